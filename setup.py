"""Builds the extension module with CMake, for `pip install --no-build-isolation --no-deps .` (docs/python.md)."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


class CMakeBuild(build_ext):
    def build_extension(self, extension):
        # A build folder of one's own is built on, not anew, and keeps the Python that it was made with.
        build = pathlib.Path(os.environ.get("SPECTRALPACK_BUILD", self.build_temp)).resolve()
        build.mkdir(parents=True, exist_ok=True)
        subprocess.run(
            ["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DSPECTRALPACK_PYTHON=ON",
             *([] if "SPECTRALPACK_BUILD" in os.environ
               else ["-DSPECTRALPACK_TESTS=OFF", f"-DPython3_EXECUTABLE={sys.executable}"]),
             *os.environ.get("CMAKE_ARGS", "").split()],
            check=True)
        subprocess.run(["cmake", "--build", build, "--target", "spectralpack_python"], check=True)
        module = next((build / "python" / "spectralpack").glob("_core*.so"))
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(module, target)


setup(
    version=re.search(r"project\(spectralpack VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1),
    ext_modules=[Extension("spectralpack._core", [])],
    cmdclass={"build_ext": CMakeBuild},
)
