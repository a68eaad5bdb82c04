# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Sourced by the scripts beside it. Moves to the top of the repository.
cd "$(dirname "$0")/.."

jobs=$(nproc)

is_debian_12() {
	grep -qs '^VERSION_CODENAME=bookworm' /etc/os-release
}

say() {
	printf '== %s\n' "$*"
}

# One hash over the names and contents of all files in the PATHs.
hash_of() {
	find "$@" -type f ! -name '*.pyc' -print0 | LC_ALL=C sort -z | xargs -0 sha256sum | sha256sum
}

# once STAMP "PATH..." COMMAND...: runs the command, unless it succeeded before on the same contents
# of the PATHs.
once() {
	stamp=$1
	key=$(hash_of $2; shift 2; echo "$@")
	shift 2
	if [ "$(cat "$stamp" 2> /dev/null)" = "$key" ]; then return; fi
	"$@"
	mkdir -p "$(dirname "$stamp")"
	echo "$key" > "$stamp"
}

# build_plugin HOST: build/release/hosts/HOST/libfilter_indexboolean.so
build_plugin() {
	tools/setup --plugin
	say "Building the plugin for $1"
	cmake --preset release > /dev/null
	cmake --build --preset release --parallel "$jobs" --target "plugin-$1"
}
