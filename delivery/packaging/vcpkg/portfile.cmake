# The library and the header of subjects, of a release's source archive.  scripts/release/packaging writes the names between @.
vcpkg_check_linkage(ONLY_STATIC_LIBRARY)
vcpkg_download_distfile(archive
  URLS "@URL@/mmverify-@VERSION@.tar.gz"
  FILENAME "mmverify-@VERSION@.tar.gz"
  SHA512 @SHA512@)
vcpkg_extract_source_archive(sources ARCHIVE "${archive}")
vcpkg_find_acquire_program(PKGCONFIG)
vcpkg_cmake_configure(SOURCE_PATH "${sources}" OPTIONS -DMMVERIFY_ONLY_LIBRARY=ON "-DPKG_CONFIG_EXECUTABLE=${PKGCONFIG}")
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/mmverify)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include")
vcpkg_install_copyright(FILE_LIST "${sources}/LICENSE")
