# The same bytes in whichever folder they are built: no path of the building machine is left in them.
add_compile_options(-ffile-prefix-map=${PROJECT_BINARY_DIR}=build -ffile-prefix-map=${PROJECT_SOURCE_DIR}=.)
# What the program has as a text; installed, it looks beside itself.
set(MMVERIFY_SOURCES_AT "/nowhere")
# What is rewritten while it is installed keeps room for the longer path.
set(CMAKE_BUILD_WITH_INSTALL_RPATH ON)
add_link_options(-Wl,--build-id=none)
set(MMVERIFY_SDSL OFF)
