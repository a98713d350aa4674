# A program that is carried to other machines, and the same bytes whichever folder it was built in: what ./run release makes
# tarballs of.  What Debian has as an archive is inside; shared libraries are looked for in ../lib/mmverify beside the program,
# where scripts/release/bundle puts them.  Embree and LLVM, some 150 MB, are left out, and so said by what needs them.
set(MMVERIFY_EMBREE OFF)
set(MMVERIFY_LLVM OFF)
add_compile_options(-ffile-prefix-map=${PROJECT_BINARY_DIR}=build -ffile-prefix-map=${PROJECT_SOURCE_DIR}=.)
# A path of the building machine that is put into the program as a text.
set(MMVERIFY_SOURCES_AT "/nowhere")
# What is rewritten while it is installed keeps room for the longer path.
set(CMAKE_BUILD_WITH_INSTALL_RPATH ON)
set(CMAKE_INSTALL_RPATH $ORIGIN/../lib/mmverify $ORIGIN/../../lib/mmverify)  # of bin/ and of libexec/mmverify/
# Also for what the bundled libraries need themselves: DT_RPATH, not DT_RUNPATH.
add_link_options(-Wl,--disable-new-dtags -Wl,--build-id=none)
# For those that are found by path, and for those that are linked by name.
list(PREPEND CMAKE_FIND_LIBRARY_SUFFIXES .a)
set(archives ${PROJECT_BINARY_DIR}/archives)
file(MAKE_DIRECTORY ${archives})
foreach(name stb sdsl)
  find_library(archive_of_${name} NAMES lib${name}.a REQUIRED)
  file(CREATE_LINK ${archive_of_${name}} ${archives}/lib${name}.a SYMBOLIC)
endforeach()
link_directories(BEFORE ${archives})
