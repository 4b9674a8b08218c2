// SPDX-License-Identifier: GPL-3.0-or-later
// Those functions of Boost.Beast that are no templates: compression, masks, UTF-8, HTTP.
// BOOST_BEAST_SEPARATE_COMPILATION leaves them to this source.
#include <boost/beast/src.hpp>
