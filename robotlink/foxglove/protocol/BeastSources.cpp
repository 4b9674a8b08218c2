// SPDX-License-Identifier: GPL-3.0-or-later
// Compiles the functions of Boost.Beast that are not templates: compression, masks, UTF-8, HTTP.
// BOOST_BEAST_SEPARATE_COMPILATION leaves them to this source.
#include <boost/beast/src.hpp>
