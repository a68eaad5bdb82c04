# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""macos_check.py ARCHITECTURE SITE: would the plugin be loaded beside pymeshlab on a Mac?

in: "arm64" or "x86_64"; a site-packages folder with both, as pip lays them out; out: a table of
the libraries that the plugin asks for, with the symbols that it imports from each and those that
are exported there, and a last line that counts them. A library of the host counts if it is the very
file that the host itself loads. macOS's own libraries are not here: a symbol counts if some library
of pymeshlab imports it from the same one, or if macos_root.py lists it. Exit status: 0 if all is as
it must be, else 1, with a sentence for each fault.
"""

import sys
from pathlib import Path

from mach_o import Host, Library, file_of, is_of_system, rpath_folders
from macos_root import MINIMUM, MORE_OF_SYSTEM, known_of_system

NEEDED = ("libmeshlab-common.dylib", "QtCore")
# What describes these types must be one with the host's: an exception that it catches, and what it
# knows a plugin by. On arm64 they are compared by name.
SHARED_TYPES = {"x86_64": ("__ZTI11MLException", "__ZTI13MeshLabPlugin"), "arm64": ()}


class Check:
    """The plugin against its host; rows (load command, imported, exported there), faults."""

    def __init__(self, architecture, site):
        self.host = Host(site / "pymeshlab")
        self.plugin = Library(site.resolve() / "indexboolean/libfilter_indexboolean.so")
        self.rows, self.faults, self.unresolved, self.pages = [], [], [], 0
        self._check_what_it_is(architecture)
        self._check_symbols()

    def _fault(self, sentence):
        self.faults.append(f"libfilter_indexboolean.so {sentence}.")

    def _check_what_it_is(self, architecture):
        if self.plugin.architecture != architecture:
            self._fault(f"is for {self.plugin.architecture}, not for {architecture}")
        if self.plugin.minimum != tuple(int(part) for part in MINIMUM.split(".")):
            self._fault(f"is for macOS {'.'.join(map(str, self.plugin.minimum))}, not {MINIMUM}")
        try:
            self.pages = self.plugin.signed_pages()
        except ValueError as error:
            self._fault(str(error))
        for name in NEEDED:
            if not any(each.endswith(f"/{name}") for each in self.plugin.dependencies):
                self._fault(f"does not ask for {name}")

        for name in SHARED_TYPES[architecture]:
            if name not in self.plugin.exports:
                self._fault(f"keeps {name} to itself")

    def exports_of(self, name):
        """What is exported by the library that a load command names, as far as is known."""
        if is_of_system(name):
            return known_of_system(self.host, name)
        path = file_of(name, self.plugin.path, rpath_folders(self.plugin))
        if path not in self.host.libraries:
            self._fault(f"asks for {name}, which pymeshlab does not load")
            return set()
        return self.host.libraries[path].exports

    def listed(self):
        """How many of the symbols are macOS's that pymeshlab does not use."""
        return sum(
            len({s for s, library in self.plugin.imports.items() if library == name}
                & set(more) - self.host.used_of_system[name])
            for name, more in MORE_OF_SYSTEM.items()
        )

    def _check_symbols(self):
        everywhere = {name: self.exports_of(name) for name in self.plugin.dependencies}
        for name, exports in everywhere.items():
            imported = {s for s, library in self.plugin.imports.items() if library == name}
            self._add(name, imported, exports)
        # Of these the loader takes the first that any library has.
        shared = {s for s, library in self.plugin.imports.items() if library not in everywhere}
        self._add("any of these", shared, set().union(*everywhere.values()))

    def _add(self, name, imported, exports):
        self.rows.append((name, len(imported), len(imported & exports)))
        for symbol in sorted(imported - exports):
            self.unresolved.append(symbol)
            self._fault(f"imports {symbol}, which {name} is not known to export")


def main():
    architecture, site = sys.argv[1], Path(sys.argv[2])
    check = Check(architecture, site)
    plugin = check.plugin
    print(
        f"{plugin.path.name}: {plugin.architecture}, macOS "
        f"{'.'.join(map(str, plugin.minimum))} or newer, {len(plugin.content)} bytes"
        + (f", signed ad hoc ({check.pages} pages)" if check.pages else "")
    )
    width = max(len(name) for name, _, _ in check.rows)
    print(f"{'library':{width}}  imported  exported there")
    for name, imported, exported in check.rows:
        print(f"{name:{width}}  {imported:8}  {exported:14}")
    total = sum(imported for _, imported, _ in check.rows)
    print("\n".join(check.faults), end="\n" if check.faults else "")
    print(
        f"macOS {architecture}: {total} symbols imported, {total - len(check.unresolved)} "
        f"resolved, {len(check.unresolved)} unresolved; {check.listed()} are macOS's that "
        "pymeshlab does not use"
    )
    return 1 if check.faults else 0


if __name__ == "__main__":
    sys.exit(main())
