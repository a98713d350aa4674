# What is written about the program, the workflows and the corpora.
if(NOT MMVERIFY_SANITIZE)
  add_test(NAME action_files_test COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/action_test.sh --files)
  add_test(NAME describe_test COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/describe_test.sh $<TARGET_FILE:mmverify>)
  set_tests_properties(describe_test PROPERTIES TIMEOUT 300)
  add_test(NAME performance_self_test COMMAND ${PROJECT_SOURCE_DIR}/scripts/performance --self-test)
  add_test(NAME skipped_tests_self_test COMMAND ${PROJECT_SOURCE_DIR}/scripts/skipped-tests --self-test)
  add_test(NAME signals_test COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/signals_test.py $<TARGET_FILE_DIR:mmverify>
    ${subjects_dir}/example.so ${PROJECT_SOURCE_DIR}/examples/subject_published/published.c $<IF:$<BOOL:${MMVERIFY_BRIEF}>,1,5>)
  set_tests_properties(signals_test PROPERTIES TIMEOUT 600)
  add_test(NAME corpora_test COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/corpora_test.sh)
  add_test(NAME contributing_test COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/contributing_test.sh)
endif()
# The installed tree, the action and CI's example, from outside.
if(NOT MMVERIFY_SANITIZE AND NOT MMVERIFY_BRIEF)  # ten seconds to a minute of a processor each
  add_test(NAME ci_workflow_test COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/ci_workflow_test.sh $<TARGET_FILE:mmverify>)
  add_test(NAME action_test COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/action_test.sh $<TARGET_FILE:mmverify>)
  set_tests_properties(action_test ci_workflow_test PROPERTIES TIMEOUT 300)
  add_test(NAME install_test
    COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/install_test.sh ${PROJECT_BINARY_DIR} ${CMAKE_C_COMPILER} ${CMAKE_CXX_COMPILER})
  add_test(NAME engine_test
    COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/engine_test.sh ${PROJECT_BINARY_DIR} ${CMAKE_C_COMPILER} ${CMAKE_CXX_COMPILER})
  set_tests_properties(engine_test PROPERTIES SKIP_RETURN_CODE 77)
  set_tests_properties(install_test engine_test PROPERTIES TIMEOUT 300)
  add_test(NAME subjects_walk_test COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/subjects_walk_test.sh)
  add_test(NAME new_topic_test COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/new_topic_test.sh
    -DCMAKE_C_COMPILER=${CMAKE_C_COMPILER} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER})
  set_tests_properties(new_topic_test PROPERTIES TIMEOUT 1800 RUN_SERIAL ON)
endif()

# The built program, from outside, as a user has it before him: tests/transcripts/README.md.
add_test(NAME transcript_self_test COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/transcript --self-test)
file(GLOB transcripts CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/transcripts transcripts/*/*.txt)
if(NOT whole_program)
  set(transcripts "")
endif()
if(MMVERIFY_BRIEF)
  # 10 to 30 seconds of a processor each.
  list(FILTER transcripts EXCLUDE REGEX
    "^(check/(bake|maps|tree)|gate/every_command|prove/every_float|report/asked_again_by_other_laws|scene/exhaustive)[.]txt$")
endif()
if(MMVERIFY_SANITIZE AND NOT MMVERIFY_EVERY_TEST)
  # What the program is handed from outside, and how it ends.
  list(FILTER transcripts INCLUDE REGEX "/(complaints|bad_files|full_disk|hostile_texts|interrupted|journal|wrong_shards|cases)[.]txt$")
endif()
foreach(transcript IN LISTS transcripts)
  string(REGEX REPLACE "\\.txt$" "" name "transcript.${transcript}")
  add_test(NAME ${name} COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/transcript $<$<BOOL:${MMVERIFY_SANITIZE}>:--sanitized>
    $<TARGET_FILE_DIR:mmverify> ${CMAKE_CURRENT_SOURCE_DIR}/transcripts/${transcript} COMMAND_EXPAND_LISTS)
  set_tests_properties(${name} PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 300
    ENVIRONMENT "SUBJECTS=${subjects_dir};SCENES=${MMVERIFY_SCENES};EXAMPLES=${PROJECT_SOURCE_DIR}/examples")
endforeach()

# Every third library of tests/subjects that is built; a brief run takes fewer.
if(NOT MMVERIFY_SANITIZE)
  add_test(NAME short_answer_test COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/short_answer_test.sh $<TARGET_FILE:mmverify-prove>
    ${subjects_dir} $<IF:$<BOOL:${MMVERIFY_BRIEF}>,16,3>)
  set_tests_properties(short_answer_test PROPERTIES TIMEOUT 1800)
endif()

# The page of mmverify report, in a browser; without Node.js, npm's registry or Chromium (./run report-test installs them)
# skipped, and so said. Its frames are timed: not beside others.
if(NOT MMVERIFY_SANITIZE)
  add_test(NAME report_page
    COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/report_page_test.sh $<TARGET_FILE:mmverify> ${CMAKE_CURRENT_BINARY_DIR}/report)
  set_tests_properties(report_page PROPERTIES SKIP_RETURN_CODE 77 LABELS report RUN_SERIAL ON TIMEOUT 600)
endif()

# Scripts under test in the npm package and on the page, as far as they go without WebAssembly; without Node.js or npm's
# registry skipped, and so said.
if(NOT MMVERIFY_SANITIZE)
  add_test(NAME script_test COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/script_test.sh ${PROJECT_BINARY_DIR}/display/report)
  set_tests_properties(script_test PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 120)
endif()

# The files of mmverify vectors, and their readers in C, Python and TypeScript; the last one without Node.js or npm's registry
# skipped, and so said.  Scripts for Amber; their shaders without glslangValidator skipped, and so said.
if(NOT MMVERIFY_SANITIZE)
  add_test(NAME vectors_files COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/vectors_test.py $<TARGET_FILE:mmverify>
    ${CMAKE_C_COMPILER} ${CMAKE_CXX_COMPILER} ${PROJECT_BINARY_DIR}/display/report)
  add_test(NAME amber_test COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/amber_test.py $<TARGET_FILE:mmverify> ${CMAKE_CXX_COMPILER})
  set_tests_properties(vectors_files amber_test PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 300)
endif()

# The Python package; without pybind11, NumPy or pip (./run install wheel) skipped, and so said.
if(NOT MMVERIFY_SANITIZE)
  add_test(NAME python_test COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/python_test.sh ${PROJECT_BINARY_DIR} $<TARGET_FILE:mmverify>
    ${subjects_dir}/example.so)
  set_tests_properties(python_test PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 600)
endif()

# A program that shoots rays at opacity micromaps of a device, on a driver of our own; without Vulkan's headers there is no
# test, without glslangValidator it is skipped, and so said.
if(TARGET mmverify_device AND NOT MMVERIFY_SANITIZE)
  add_library(device_stand_in MODULE outside/device/builds.cpp outside/device/stand_in.cpp)
  target_include_directories(device_stand_in PRIVATE ${PROJECT_SOURCE_DIR}
    $<TARGET_PROPERTY:mmverify_device,INTERFACE_INCLUDE_DIRECTORIES>)
  target_compile_definitions(device_stand_in PRIVATE VK_NO_PROTOTYPES)
  set_target_properties(device_stand_in PROPERTIES CXX_VISIBILITY_PRESET hidden)
  add_test(NAME device_test COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/device_test.sh
    $<$<BOOL:${MMVERIFY_BRIEF}>:--brief> $<TARGET_FILE:mmverify> $<TARGET_FILE:device_stand_in> ${CMAKE_CXX_COMPILER} COMMAND_EXPAND_LISTS)
  set_tests_properties(device_test PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 600)
endif()

# Functions in sources; without clang or llvm-14-dev skipped, and so said.
if(NOT MMVERIFY_SANITIZE)
  add_test(NAME source_test COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/source_test.sh $<TARGET_FILE:mmverify-prove> ${PROJECT_SOURCE_DIR}
    $<$<BOOL:${MMVERIFY_BRIEF}>:--brief> $<$<BOOL:${MMVERIFY_EVERY_TEST}>:--every> COMMAND_EXPAND_LISTS)
  add_test(NAME source_promises_test
    COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/source_promises_test.sh $<TARGET_FILE:mmverify-prove>)
  add_test(NAME codec_command_test
    COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/codec_command_test.sh $<TARGET_FILE:mmverify-prove> ${PROJECT_SOURCE_DIR})
  add_test(NAME own_codecs_test
    COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/own_codecs_test.sh $<TARGET_FILE:mmverify-prove>)
  # A codec in Rust; without a rustc of clang's LLVM or an older one skipped, and so said.
  if(NOT MMVERIFY_BRIEF)
    add_test(NAME rust_codec_test
      COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/rust_codec_test.sh $<TARGET_FILE:mmverify-prove> ${PROJECT_SOURCE_DIR})
    set_tests_properties(rust_codec_test PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 900)
  endif()
  set_tests_properties(codec_command_test own_codecs_test source_test source_promises_test PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 900 COST 1000)
endif()

# Implementations of others, by stand-ins of the same shape.
if(NOT MMVERIFY_SANITIZE)
  add_test(NAME implementations_test
    COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/implementations_test.sh $<TARGET_FILE:mmverify> ${PROJECT_SOURCE_DIR})
  set_tests_properties(implementations_test PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 300)
endif()

# Every harness on its corpus.
if(MMVERIFY_FUZZ)
  foreach(name ${MMVERIFY_HARNESSES})
    add_test(NAME fuzz_${name}_corpus COMMAND fuzz_${name} -runs=0 ${PROJECT_BINARY_DIR}/seeds/${name})
    set_tests_properties(fuzz_${name}_corpus PROPERTIES LABELS corpus)
  endforeach()
endif()
if(NOT MMVERIFY_SANITIZE)
  # A harness that cannot find what was planted finds nothing.  The night has the harnesses with a mistake compiled in.
  function(mmverify_add_planted name program finding)
    if(MMVERIFY_BRIEF AND program MATCHES "_planted_replay$")
      return()
    endif()
    add_test(NAME fuzz_${name}_finds_what_was_planted COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/finds_planted_test.sh
      $<TARGET_FILE:${program}> ${PROJECT_BINARY_DIR}/seeds/${name} ${finding})
  endfunction()
  mmverify_add_planted(attribute_container fuzz_attribute_container_planted_replay
    "attribute_container: other bytes of the same maps")
  mmverify_add_planted(bake_differential fuzz_bake_differential_planted_replay
    "bake: level [0-9]+, micro-triangle [0-9]+: [01], expected [23]")  # settled, and is unknown
  mmverify_add_planted(scene_validate fuzz_scene_validate_planted_replay "scene: clean, with an index of no record")
  mmverify_add_planted(vq_encode fuzz_vq_encode_planted_replay "vq2: the optimum is not conservative, region [0-9]+,[0-9]+")
  # Without a file a harness must fail, or an empty corpus would pass for ever.
  add_test(NAME fuzz_replay_without_a_file COMMAND fuzz_index_differential_replay)
  add_test(NAME fuzz_replay_of_a_missing_file COMMAND fuzz_index_differential_replay no/such/file)
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/empty)
  add_test(NAME fuzz_replay_of_an_empty_folder COMMAND fuzz_index_differential_replay ${CMAKE_CURRENT_BINARY_DIR}/empty)
  set_tests_properties(fuzz_replay_without_a_file fuzz_replay_of_a_missing_file fuzz_replay_of_an_empty_folder
    PROPERTIES WILL_FAIL ON)
endif()

# Real runs on a Slurm cluster of this one machine; without Slurm (./run cluster-test installs it) skipped, and so said.
# Not under sanitizers: its waits are for a program of the usual speed.
if(NOT MMVERIFY_SANITIZE)
  add_test(NAME slurm_test COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/outside/slurm_test.sh $<TARGET_FILE:mmverify>)
  set_tests_properties(slurm_test PROPERTIES SKIP_RETURN_CODE 77 LABELS cluster RUN_SERIAL ON TIMEOUT 300)
endif()

# The theorems of proofs/coq; without Coq (./run coq installs it) skipped, and so said. Coq's kernel takes a minute: the night
# has it.
if(NOT MMVERIFY_SANITIZE AND NOT MMVERIFY_BRIEF)
  add_test(NAME coq_test COMMAND ${PROJECT_SOURCE_DIR}/scripts/check-coq $<TARGET_FILE:mmverify>)
  set_tests_properties(coq_test PROPERTIES SKIP_RETURN_CODE 77 LABELS coq TIMEOUT 600)
endif()
