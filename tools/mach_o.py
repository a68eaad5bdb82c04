# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A library of macOS as its loader sees it: what it asks for, what it offers, how it is signed."""

import hashlib
import struct
from pathlib import Path

import lief

_MAGIC = bytes.fromhex("cffaedfe")  # 64 bits, little-endian
_SIGNATURE, _CODE_DIRECTORY, _AD_HOC, _SHA256 = 0xFADE0CC0, 0xFADE0C02, 0x2, 2


def is_of_system(name):
    """Whether a load command names what macOS itself has."""
    return name.startswith(("/usr/lib/", "/System/Library/"))


class Library:
    """One library of one processor.

    architecture "arm64" or "x86_64"; minimum, of macOS, as (11, 0); dependencies, the names in its
    load commands; rpaths; imports {symbol: the dependency that is to have it, or None for any};
    exports, a set; content, its bytes.
    """

    def __init__(self, path):
        self.path = Path(path)
        self.content = self.path.read_bytes()
        fat = lief.MachO.parse(str(path))  # owns what it gives out
        binary = fat.at(0)
        self.architecture = binary.header.cpu_type.name.lower()
        build = binary.build_version if binary.has_build_version else binary.version_min
        self.minimum = tuple(build.minos if binary.has_build_version else build.version)[:2]
        self.dependencies = [
            each.name for each in binary.libraries if each.command.name != "ID_DYLIB"
        ]
        self.rpaths = [each.path for each in binary.rpaths]
        self.imports = {
            each.name: self._dependency(each.library_ordinal) for each in binary.imported_symbols
        }
        self.exports = {each.name for each in binary.exported_symbols}
        self._signature = None
        if binary.has_code_signature:
            part = binary.code_signature
            self._signature = part.data_offset, part.data_size

    def _dependency(self, ordinal):
        return self.dependencies[ordinal - 1] if 0 < ordinal <= len(self.dependencies) else None

    def signed_pages(self):
        """How many pages the ad-hoc signature covers: all of them, as they are.

        Raises ValueError with a sentence if there is none, or it is another's.
        """
        if self._signature is None:
            raise ValueError("is not signed")
        start, size = self._signature
        signature = self.content[start:start + size]
        directory = _code_directory(signature)
        flags, hashes, _, _, pages, limit = struct.unpack_from(">6I", directory, 12)
        hash_size, kind, _, log_page = struct.unpack_from("4B", directory, 36)
        if not flags & _AD_HOC or kind != _SHA256:
            raise ValueError("has a signature of another kind")
        if limit != start or pages != -(-limit >> log_page):
            raise ValueError(f"has a signature over {limit} bytes where there are {start}")
        for page in range(pages):
            begin, end = page << log_page, min(page + 1 << log_page, limit)
            at = hashes + page * hash_size
            if hashlib.sha256(self.content[begin:end]).digest() != directory[at:at + hash_size]:
                raise ValueError(f"has been changed after it was signed, in page {page}")
        return pages


def _begins_as_library(path):
    with path.open("rb") as file:
        return file.read(4) == _MAGIC


def _code_directory(signature):
    magic, _, count = struct.unpack_from(">3I", signature)
    if magic != _SIGNATURE:
        raise ValueError("has no signature where it says so")
    for part in range(count):
        _, offset = struct.unpack_from(">2I", signature, 12 + 8 * part)
        kind, size = struct.unpack_from(">2I", signature, offset)
        if kind == _CODE_DIRECTORY:
            return signature[offset:offset + size]
    raise ValueError("has a signature without a code directory")


def file_of(name, loader, rpaths):
    """The file that a load command of the file `loader` names, or None.

    rpaths: folders for @rpath. As the loader, but for what is relative to the program.
    """
    if name.startswith("@loader_path/"):
        places = [loader.parent / name.removeprefix("@loader_path/")]
    elif name.startswith("@rpath/"):
        places = [folder / name.removeprefix("@rpath/") for folder in rpaths]
    else:
        places = []
    return next((place.resolve() for place in places if place.is_file()), None)


def rpath_folders(library):
    """The folders that @rpath stands for in its load commands."""
    return [
        library.path.parent / path.removeprefix("@loader_path/") for path in library.rpaths
        if path.startswith("@loader_path/")
    ]


class Host:
    """pymeshlab's wheel for macOS, unpacked: the libraries that are loaded with it.

    libraries {file: Library} of what its extension module loads, directly or not; used_of_system
    {name of a system library: symbols that any library of the wheel imports from it}.
    """

    def __init__(self, package):
        self.package = Path(package).resolve()
        (module,) = self.package.glob("pmeshlab*.so")
        self.libraries = {}
        self._load(Library(module), [])
        self.used_of_system = {}
        for path in self.package.rglob("*"):
            if path.is_file() and _begins_as_library(path):
                self._note_system_symbols(self.libraries.get(path) or Library(path))

    def _load(self, library, rpaths):
        self.libraries[library.path] = library
        rpaths = rpath_folders(library) + rpaths
        for name in library.dependencies:
            path = file_of(name, library.path, rpaths)
            if path and path not in self.libraries:
                self._load(Library(path), rpaths)

    def _note_system_symbols(self, library):
        for symbol, name in library.imports.items():
            if name and is_of_system(name):
                self.used_of_system.setdefault(name, set()).add(symbol)
