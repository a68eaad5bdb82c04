# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""macos_root.py ARCHITECTURE PYMESHLAB ROOT: what cmake/toolchains/macos.cmake builds with.

in: "arm64" or "x86_64"; the folder of pymeshlab's wheel for that processor, unpacked; out: ROOT
with bin/c++ and bin/ar (zig), include/ and lib/.

A plugin is linked with stubs: lists of names. Those of the host's libraries name what these
export, and where they are from the plugin, which lies in a package beside the host's. Those of the
system's libraries name what the host's own libraries import from them, which is on any Mac that
runs the host, and a few names more, listed here. So a plugin that links needs nothing that is not
there.
"""

import shutil
import sys
from pathlib import Path

import ziglang
from mach_o import Host

MINIMUM = "11.0"  # of macOS: pymeshlab's
ZIG_NAME = {"arm64": "aarch64", "x86_64": "x86_64"}
QT_MODULES = ("Core", "Gui", "Widgets", "OpenGL", "Xml")
HOST_LIBRARIES = (
    "libmeshlab-common.dylib",
    *(f"Qt{module}.framework/Versions/5/Qt{module}" for module in QT_MODULES),
)
SYSTEM_LIBRARIES = ("/usr/lib/libc++.1.dylib", "/usr/lib/libSystem.B.dylib")
# What macOS 11 has as well, but pymeshlab happens not to import: names of C99 and of C++17. Wheels
# for macOS 11 of numpy, libigl, manifold3d, vtk or duckdb import them, but for a string's copy,
# C99's lround and its default environment, which are as old as these libraries. pymeshlab for arm64
# imports the thread's mask of signals, that for x86_64 does not.
MORE_OF_SYSTEM = {
    "/usr/lib/libc++.1.dylib": (
        "__ZNSt11logic_errorC1EPKc", "__ZNSt11logic_errorD1Ev", "__ZNSt11range_errorD1Ev",
        "__ZNSt14overflow_errorD1Ev", "__ZNSt14overflow_errorD2Ev",
        "__ZNSt3__112basic_stringIcNS_11char_traitsIcEENS_9allocatorIcEEEC1ERKS5_",
        "__ZNSt3__118condition_variable10notify_allEv",
        "__ZNSt3__118condition_variable10notify_oneEv",
        "__ZNSt3__118condition_variable4waitERNS_11unique_lockINS_5mutexEEE",
        "__ZNSt3__118condition_variableD1Ev",
        "__ZNSt3__16__sortIRNS_6__lessIyyEEPyEEvT0_S5_T_",
        "__ZTVNSt3__115basic_streambufIcNS_11char_traitsIcEEEE", "__ZTVSt11range_error",
        "__ZTVSt14overflow_error", "__ZdlPvSt11align_val_t", "__ZnwmSt11align_val_t",
    ),
    "/usr/lib/libSystem.B.dylib": (
        "__FE_DFL_ENV", "___udivti3", "___umodti3", "_ceilf", "_fegetenv", "_fesetenv", "_floor",
        "_ilogb", "_lround", "_nextafterf", "_pthread_sigmask", "_scalbn",
    ),
}
# Of no system: Boost, Eigen, OpenGL's and Qt's headers.
HEADERS = {
    "boost": "/usr/include/boost", "eigen3": "/usr/include/eigen3", "GL": "/usr/include/GL",
    "KHR": "/usr/include/KHR", "qt5": "/usr/include/x86_64-linux-gnu/qt5",
}

STUB = """--- !tapi-tbd
tbd-version: 4
targets: [ {architecture}-macos ]
install-name: '{install_name}'
exports:
  - targets: [ {architecture}-macos ]
    symbols: [ {symbols} ]
...
"""

# The operator delete that is given a size is not among what the host's libraries use.
# What is linked through it, by CMake to see what compiler it is, needs no C++ library: zig would
# build its own first.
COMPILER = """#!/bin/sh
case " $* " in
*" -c "* | *" -E "*) ;;
*) set -- -nostdlib++ "$@" ;;
esac
export ZIG_GLOBAL_CACHE_DIR="{cache}"
exec "{zig}" c++ -target {target}-macos.{minimum} -fno-sized-deallocation "$@"
"""
ARCHIVER = '#!/bin/sh\nexec "{zig}" ar "$@"\n'


def write_stub(path, architecture, install_name, symbols):
    quoted = ", ".join(f"'{symbol}'" for symbol in sorted(symbols))
    path.write_text(
        STUB.format(architecture=architecture, install_name=install_name, symbols=quoted)
    )


def known_of_system(host, name):
    """The symbols that are known to be exported by one of macOS's libraries."""
    return host.used_of_system.get(name, set()) | set(MORE_OF_SYSTEM.get(name, ()))


def write_stubs(folder, architecture, host):
    for name in HOST_LIBRARIES:
        library = host.libraries[host.package / "Frameworks" / name]
        stub = folder / f"{Path(name).stem}.tbd"
        write_stub(stub, architecture, f"@rpath/{name}", library.exports)
    for name in SYSTEM_LIBRARIES:
        stub = folder / f"{Path(name).name.split('.')[0]}.tbd"
        write_stub(stub, architecture, name, known_of_system(host, name))


def write_programs(folder, architecture):
    zig = Path(ziglang.__file__).with_name("zig")
    words = {
        "zig": zig, "cache": folder.parents[2] / "zig-cache", "minimum": MINIMUM,
        "target": ZIG_NAME[architecture],
    }
    for name, text in (("c++", COMPILER), ("ar", ARCHIVER)):
        program = folder / name
        program.write_text(text.format(**words))
        program.chmod(0o755)


def gather_headers(folder):
    for name, place in HEADERS.items():
        (folder / name).symlink_to(place)
    # Qt and GLEW include OpenGL by Apple's names for it.
    (folder / "OpenGL").mkdir()
    for name in ("gl.h", "glext.h", "glu.h", "gl3.h"):
        common = "glcorearb.h" if name == "gl3.h" else name
        (folder / "OpenGL" / name).symlink_to(f"/usr/include/GL/{common}")


def main():
    architecture, package, root = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3]).resolve()
    shutil.rmtree(root, ignore_errors=True)
    for folder in ("bin", "include", "lib"):
        (root / folder).mkdir(parents=True)
    (root / "architecture").write_text(f"{architecture}\n")
    write_programs(root / "bin", architecture)
    gather_headers(root / "include")
    write_stubs(root / "lib", architecture, Host(package))


if __name__ == "__main__":
    main()
