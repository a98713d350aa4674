# A program that is carried to other machines: what ./run release makes tarballs of.  What Debian has as an archive is inside;
# shared libraries are looked for in ../lib/mmverify beside the program, where scripts/release/bundle puts them.  LLVM, 107 MB,
# is left out, and what needs it says so.
set(MMVERIFY_LLVM OFF)
set(CMAKE_INSTALL_RPATH $ORIGIN/../lib/mmverify $ORIGIN/../../lib/mmverify)  # of bin/ and of libexec/mmverify/
# Also for what the bundled libraries need themselves: DT_RPATH, not DT_RUNPATH.
add_link_options(-Wl,--disable-new-dtags)
# For those that are found by path, and for the one that is linked by name.
list(PREPEND CMAKE_FIND_LIBRARY_SUFFIXES .a)
set(archives ${PROJECT_BINARY_DIR}/archives)
file(MAKE_DIRECTORY ${archives})
find_library(archive_of_stb NAMES libstb.a REQUIRED)
file(CREATE_LINK ${archive_of_stb} ${archives}/libstb.a SYMBOLIC)
link_directories(BEFORE ${archives})
