"""The library and the header of subjects, of a release's source archive.  scripts/release/packaging writes the names between @."""
from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, get
from conan.tools.gnu import PkgConfigDeps


class Mmverify(ConanFile):
    name = "mmverify"
    version = "@VERSION@"
    description = "Opacity micromaps: exact indices, bakers, trees; and the header by which others' code is judged"
    license = "MIT"
    package_type = "static-library"
    settings = "os", "compiler", "build_type", "arch"
    options = {"fPIC": [True]}
    default_options = {"fPIC": True}

    def requirements(self):
        self.requires("highway/[>=1.0.3 <2]")

    def layout(self):
        cmake_layout(self)

    def source(self):
        get(self, "@URL@/mmverify-@VERSION@.tar.gz", sha256="@SHA256@", strip_root=True)

    def generate(self):
        PkgConfigDeps(self).generate()
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.variables["MMVERIFY_ONLY_LIBRARY"] = True
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, self.package_folder + "/licenses")
        CMake(self).install()

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "mmverify")
        self.cpp_info.components["impl"].libs = ["mmverify_impl"]
        self.cpp_info.components["impl"].requires = ["highway::highway"]
        self.cpp_info.components["impl"].set_property("cmake_target_name", "mmverify::impl")
        self.cpp_info.components["subject"].set_property("cmake_target_name", "mmverify::subject")
