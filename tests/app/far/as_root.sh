#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a program as root of a user namespace of its own, where the system permits that, so that it may make networks.
if [ "$(id -u)" != 0 ] && unshare --map-root-user --net true 2>/dev/null; then
  exec unshare --map-root-user "$@"
fi
exec "$@"
