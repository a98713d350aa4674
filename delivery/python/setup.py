"""The wheel: pip wheel delivery/python --no-build-isolation --no-deps, or ./run wheel (docs/PYTHON.md).

The extension module is a target of the project's own CMake. Where MMVERIFY_BUILD names a configured build folder, it is
built there; else in build/python, with the library and without the rest of the project.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HERE = pathlib.Path(__file__).resolve().parent
SCRATCH = ROOT / "build" / "python"


class BuildWithCMake(build_ext):
    def build_extension(self, extension):
        folder = pathlib.Path(os.environ.get("MMVERIFY_BUILD") or self.configured())
        subprocess.run(["cmake", "--build", folder, "--target", "mmverify_python"], check=True)
        name = "_core" + sysconfig.get_config_var("EXT_SUFFIX")
        built = folder / "delivery" / "python" / "mmverify" / name
        if not built.is_file():
            sys.exit(f"mmverify: {folder} made no {name}: it was configured with another Python than {sys.executable}")
        to = pathlib.Path(self.get_ext_fullpath(extension.name))
        to.parent.mkdir(parents=True, exist_ok=True)
        highway = [*built.parent.glob("libhwy.so.*"), *built.parent.glob("LICENSE.highway")]
        for file in [built, *highway, ROOT / "LICENSE"]:
            shutil.copy2(file, to.parent)

    def configured(self):
        folder = SCRATCH / "cmake"
        options = ["MMVERIFY_ONLY_LIBRARY=ON", "MMVERIFY_PYTHON=ON", f"Python_EXECUTABLE={sys.executable}"]
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        command = ["cmake", "-S", ROOT, "-B", folder, *generator, "-D", "CMAKE_BUILD_TYPE=Release"]
        subprocess.run([*command, *(word for option in options for word in ("-D", option))], check=True)
        return folder


# A file that is gone from the sources would stay in the wheel.
shutil.rmtree(SCRATCH / "setuptools", ignore_errors=True)
SCRATCH.mkdir(parents=True, exist_ok=True)
os.chdir(HERE)
setup(
    version=re.search(r"project\(mmverify VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1],
    license=re.search(r"\S.*", (ROOT / "LICENSE").read_text(encoding="utf-8"))[0].strip(),
    ext_modules=[Extension("mmverify._core", [])],
    cmdclass={"build_ext": BuildWithCMake},
    # Nothing is left among the sources.
    options={"build": {"build_base": str(SCRATCH / "setuptools")}, "egg_info": {"egg_base": str(SCRATCH)}},
)
