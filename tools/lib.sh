# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Sourced by the scripts here and in bench/. Moves to the top of the repository.
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

# build_with_commit COMMIT TARGET: builds the target here and in out/guard/tree, the commit's tree.
build_with_commit() {
	checkout_commit "$1"
	for tree in . out/guard/tree; do
		(
			cd "$tree"
			cmake --preset release > /dev/null
			cmake --build --preset release --parallel "$jobs" --target "$2"
		)
	done
}

# checkout_commit COMMIT: makes out/guard/tree the tree of the commit, with the headers of this one.
# Its build stays there for the next time.
checkout_commit() {
	git rev-parse --quiet --verify "$1^{commit}" > /dev/null || {
		echo "$0: no such commit: $1" >&2
		exit 2
	}
	if [ -e out/guard/tree/.git ]; then
		git -C out/guard/tree checkout --quiet --detach "$(git rev-parse "$1")"
	else
		git worktree prune
		git worktree add --quiet --detach out/guard/tree "$1"
	fi
	mkdir -p out/guard/tree/build
	for headers in build/meshlab-*; do
		[ ! -e "$headers" ] || ln -sfn "$(realpath "$headers")" out/guard/tree/build/
	done
}
