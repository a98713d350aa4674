# mmverify.wasm, and the JavaScript that emscripten makes for it; in the place of what else cli/CMakeLists.txt makes.
file(GLOB sources CONFIGURE_DEPENDS scene/*.cpp validate/*.cpp)
add_executable(mmverify ${sources} attributes/check.cpp bench/plot.cpp output/plot_file.cpp output/png_file.cpp output/sarif.cpp prove/pipe.cpp
  results/gate.cpp results/merge.cpp results/read_json.cpp vectors/command.cpp vectors/folder.cpp wasm_commands.cpp ${PROJECT_SOURCE_DIR}/bench/scene/size_panels.cpp)
target_link_libraries(mmverify PRIVATE mmverify_cli mmverify::gate mmverify::impl mmverify::scene mmverify::scene_laws
  mmverify::program mmverify::vectors)
foreach(part mmverify_cli mmverify)
  mmverify_unite(${part})
  target_compile_options(${part} PRIVATE ${quick_to_compile})
endforeach()
# One program for Node.js and for pages: its caller says where files are, and starts main as often as it likes.
target_link_options(mmverify PRIVATE -O2 -fwasm-exceptions -sMODULARIZE=1 -sEXPORT_ES6=1 -sEXPORT_NAME=createProgram
  -sENVIRONMENT=web,worker,node -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=2GB -sTOTAL_STACK=4MB -sINVOKE_RUN=0 -sNODEJS_CATCH_EXIT=0 -sNODEJS_CATCH_REJECTION=0 -sEXIT_RUNTIME=0
  -sFORCE_FILESYSTEM=1 -sEXPORTED_RUNTIME_METHODS=FS,callMain,NODEFS -sINCOMING_MODULE_JS_API=instantiateWasm,preRun,noInitialRun,thisProgram -lnodefs.js)
# Debian's packages for Node.js lie where a Node.js that is not Debian's does not look.
set_property(TARGET mmverify PROPERTY RULE_LAUNCH_LINK "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs")
