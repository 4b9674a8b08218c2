// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels compiled for processors with AVX2; see KernelTypes.h.
#include "simcore/rendering/DrawKernel.h"
#include "simcore/rendering/OutputKernel.h"
#include "simcore/rendering/ShadeKernel.h"

namespace simcore::rendering {

const Kernels kAvx2Kernels = {draw, shade, settle, writeYuyv, writeRgb, addNoise};

}  // namespace simcore::rendering
