# Decoders of what files may be compressed with, each optional: without one all else is read, and a file that needs it is
# refused with the library's name.
option(MMVERIFY_DECODERS "Link the decoders of compressed meshes and pictures that are found" ON)

# A decoder under its word of MMVERIFY_HAS_..., linked if its target is there.
function(mmverify_decoder word target what package)
  if(MMVERIFY_DECODERS AND TARGET ${target})
    target_compile_definitions(mmverify_scene PRIVATE MMVERIFY_HAS_${word})
    target_link_libraries(mmverify_scene PRIVATE ${target})
  else()
    message(STATUS "No ${what} (Debian: ${package}): files that need it are refused, by its name")
  endif()
endfunction()

if(MMVERIFY_DECODERS AND NOT CMAKE_CROSSCOMPILING)  # or it would find the building machine's
  set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)  # programs of other folders link the scene's library, and so these
  find_package(meshoptimizer QUIET CONFIG)
  find_package(draco QUIET CONFIG)
  pkg_check_modules(webp QUIET IMPORTED_TARGET GLOBAL libwebp)
  pkg_check_modules(zstd QUIET IMPORTED_TARGET GLOBAL libzstd)
  find_package(libavif QUIET CONFIG)
  if(TARGET avif)  # its library brings three coders of video, 20 MB, so the program opens it where a file needs it
    mmverify_opened(avif_opened AVIF avif)
  endif()
  if(NOT MMVERIFY_PORTABLE)  # OpenEXR has no static library
    find_package(OpenEXR QUIET CONFIG)
  endif()
  unset(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL)
endif()
mmverify_decoder(MESHOPT meshoptimizer::meshoptimizer "meshoptimizer" libmeshoptimizer-dev)
mmverify_decoder(DRACO draco::draco "Draco" libdraco-dev)
mmverify_decoder(WEBP PkgConfig::webp "WebP" libwebp-dev)
mmverify_decoder(AVIF avif_opened "AVIF" libavif-dev)
mmverify_decoder(OPENEXR OpenEXR::OpenEXR "OpenEXR" libopenexr-dev)
mmverify_decoder(ZSTD PkgConfig::zstd "Zstandard" libzstd-dev)
