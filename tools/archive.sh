# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Sourced by the scripts beside it that fetch from Debian.

# The archive that this system's apt takes its own release from; nothing if there is none.
archive() {
	codename=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
	apt-get update --print-uris 2> /dev/null |
		sed -n "s,^'\(.*\)/dists/\($codename\|stable\|oldstable\)/main/binary-.*,\1,p" | head -n 1
}
