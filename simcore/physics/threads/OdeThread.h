// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace simcore {

/// Prepares ODE for use by the calling thread; cheap after the first call.
void prepareOdeForThread();

}  // namespace simcore
