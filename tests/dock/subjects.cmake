# Shared libraries to judge: the example, ours, wrong ones, misbehaving ones.
# Of those of topics other than index, ./run test --brief links the ones that of_every_change names: the examples, those of
# large batches, and those that transcripts, a harness and scripts/ignored-fields judge.  The others are linked on demand.
set(of_every_change "^(ignoring|large_batches_.*|.*_example|tree_merges_ut|bake_settles_all)$")
function(mmverify_add_subject name source)
  add_library(subject_${name} MODULE ${source})
  target_include_directories(subject_${name} PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/subjects/sdk)
  target_compile_definitions(subject_${name} PRIVATE ${ARGN})
  set_target_properties(subject_${name} PROPERTIES PREFIX "" OUTPUT_NAME ${name} LIBRARY_OUTPUT_DIRECTORY ${subjects_dir})
  if(MMVERIFY_BRIEF AND judged_by STREQUAL subjects_tests AND NOT name MATCHES "${of_every_change}")
    set_target_properties(subject_${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    return()
  endif()
  add_dependencies(${judged_by} subject_${name})
endfunction()
# mmverify_add_part(NAME SOURCE [DEFINITION...]): what several libraries have in common, compiled once.
function(mmverify_add_part name source)
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${source})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/subjects/sdk)
  target_compile_definitions(${name} PRIVATE ${ARGN})
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
endfunction()
# mmverify_add_wrong(NAME THING LIBRARY...): of the parts among the libraries, with one thing wrong of those that are asked.
function(mmverify_add_wrong name thing)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/wrong/${thing}.c)
  file(CONFIGURE OUTPUT ${source} CONTENT "const char wrong_thing[] = \"${thing}\";\n")
  mmverify_add_subject(${name} ${source})
  target_link_libraries(subject_${name} PRIVATE ${ARGN})
  set_target_properties(subject_${name} PROPERTIES LINKER_LANGUAGE CXX)
endfunction()
mmverify_add_test(entry_points_test)
target_compile_definitions(entry_points_test PRIVATE MMVERIFY_HEADER="${PROJECT_SOURCE_DIR}/subjects/sdk/mmverify_subject.h")
set(judged_by plugin_test)
mmverify_add_test(plugin_test)
target_compile_definitions(plugin_test PRIVATE MMVERIFY_PROGRAM="$<TARGET_FILE:mmverify>"
  MMVERIFY_SUBJECTS="${subjects_dir}" MMVERIFY_EXAMPLES="${PROJECT_SOURCE_DIR}/examples")
add_dependencies(plugin_test mmverify mmverify-worker)
mmverify_add_subject(example ${PROJECT_SOURCE_DIR}/examples/subject/subject.c)
mmverify_add_subject(published ${PROJECT_SOURCE_DIR}/examples/subject_published/published.c)
mmverify_add_subject(batched subjects/batched.cpp DECLARED=MMVERIFY_CORNERS_OF_CHILDREN)
mmverify_add_subject(batched_undeclared subjects/batched.cpp DECLARED=0)
mmverify_add_subject(batched_misdeclared subjects/batched.cpp DECLARED=MMVERIFY_CORNERS_BASE_U_V)
foreach(batched batched batched_undeclared batched_misdeclared)
  target_link_libraries(subject_${batched} PRIVATE mmverify::impl)
endforeach()
foreach(face c_face c_face_trees)
  mmverify_add_subject(${face} subjects/${face}.c)
  target_link_libraries(subject_${face} PRIVATE mmverify::impl)
  set_target_properties(subject_${face} PROPERTIES LINKER_LANGUAGE CXX)
endforeach()
# What an engine in another language calls is what the laws are true of.
set(judging_c_face mmverify prove --subject ${subjects_dir}/c_face.so --no-mutants --quiet)
if(whole_program)
  set(last_level_of_maps 3)
  set(last_level_of_bakers 2)
  if(MMVERIFY_BRIEF OR MMVERIFY_SANITIZE)  # which makes each case take ten times as long
    set(last_level_of_maps 1)
    set(last_level_of_bakers 0)
  endif()
  add_test(NAME c_face_of_maps COMMAND ${judging_c_face} index micromap tree --levels 0..${last_level_of_maps})
  add_test(NAME c_face_of_trees COMMAND mmverify prove tree --subject ${subjects_dir}/c_face_trees.so --no-mutants --quiet
    --levels 0..${last_level_of_maps})
  add_test(NAME c_face_of_blocks COMMAND ${judging_c_face} vq2.region_is_map vq4.region_is_map vq2.conservative)
  add_test(NAME c_face_of_bakers COMMAND ${judging_c_face} bake.conservative bake.tight --levels 0..${last_level_of_bakers})
endif()
# As docs/SUBJECTS.md builds them; a sanitized worker has its own runtime.
if(NOT MMVERIFY_SANITIZE AND CMAKE_C_COMPILER_ID STREQUAL GNU)
  mmverify_add_subject(address_sanitized subjects/sanitized.c READS_PAST_ITS_TABLE)
  mmverify_add_subject(undefined_sanitized subjects/sanitized.c)
  foreach(sanitizer address undefined)
    target_compile_options(subject_${sanitizer}_sanitized PRIVATE -g -fsanitize=${sanitizer})
    target_link_options(subject_${sanitizer}_sanitized PRIVATE -fsanitize=${sanitizer})
  endforeach()
  target_compile_definitions(plugin_test PRIVATE MMVERIFY_SANITIZED_SUBJECTS)
endif()
mmverify_add_part(misbehaving subjects/misbehaving.cpp)
foreach(misbehaviour crash hang overrun underrun exits throws rounds counts_calls sees_batch sees_threads writes_input
    tie prints unwritten forks fills_memory opens_files writes_a_file prints_on starts_threads kills_parent
    keeps_the_last counts_in_16_bits sees_order sees_addresses shares_a_buffer shares_a_large_buffer publishes_early
    fills_its_end_last fills_level_16_last keeps_parents takes_its_time crash_and_tie crash_at_5 crash_on_all)
  mmverify_add_wrong(${misbehaviour} ${misbehaviour} misbehaving)
endforeach()
mmverify_add_tests(hostile_test hostile_test clean_text_test elf_symbols_test LIBRARIES mmverify::dock)
target_compile_definitions(hostile_test PRIVATE MMVERIFY_SUBJECTS="${subjects_dir}"
  MMVERIFY_WORKER_PROGRAM="$<TARGET_FILE:mmverify-worker>")
add_dependencies(hostile_test mmverify-worker subject_example subject_tie)
set(judged_by hostile_test)
mmverify_add_part(hostile subjects/hostile.cpp)
foreach(harm ends_itself signals_the_tool leaves_its_group reaches_the_tool writes_to_terminals looks_for_descriptors shrinks_the_memory hides_memory
    unlocks_its_input reports_no_such_outcome reports_without_end reports_no_such_element takes_no_such_turn fills_the_mailbox
    begins_nowhere is_at_another_level reports_the_machine answers_without_bounds describes_without_end is_ready_before_it_is
    hangs_while_loaded never_describes_itself hangs_when_loaded_again crashes_when_loaded_again sleeps flushes_when_loaded
    rounds_when_loaded rounds_in_its_first_call rounds_in_threads halves_x87_precision names_itself_badly throws_escapes
    throws_half_a_character prints_commands fills_a_folder rewrites_itself crashes_then_hangs is_slow)
  mmverify_add_wrong(hostile_${harm} ${harm} hostile)
endforeach()
mmverify_add_subject(no_threads subjects/no_threads.c)
set(judged_by plugin_test)
add_dependencies(plugin_test hostile_test)
mmverify_add_part(wrong_order subjects/wrong_order.cpp)
foreach(order swapped_from_level_2 rows u_and_v_exchanged ties_then_inside level_forgotten level_1_declared)
  mmverify_add_wrong(${order} ${order} wrong_order)
endforeach()
foreach(fault 0 1 2)
  mmverify_add_subject(fault_${fault} subjects/no_subject.c FAULT=${fault})
endforeach()

mmverify_add_room(subjects_tests large_batches_test tree_plugin_test dag_plugin_test vq_plugin_test forgetful_plugin_test touchy_plugin_test traverse_plugin_test array_plugin_test array_changes_plugin_test attribute_plugin_test
  attribute_bake_plugin_test bake_plugin_test mesh_plugin_test subdivision_plugin_test LIBRARIES mmverify::proofs)
target_compile_definitions(subjects_tests PRIVATE MMVERIFY_PROGRAM="$<TARGET_FILE:mmverify>" MMVERIFY_SUBJECTS="${subjects_dir}")
add_dependencies(subjects_tests mmverify mmverify-worker)
set(judged_by subjects_tests)

# Those that are called with many thousand elements at once.
foreach(kind RIGHT SEES_BATCH CRASHES NOT_HERE UNWRITTEN WRITES_BEHIND)
  mmverify_add_subject(large_batches_${kind} subjects/large_batches.cpp KIND=${kind})
  target_link_libraries(subject_large_batches_${kind} PRIVATE mmverify::impl)
endforeach()

# The same of maps and codes: the example of a tree, and what it is when one thing is wrong.
set(tree_example ${PROJECT_SOURCE_DIR}/examples/subject_tree/subject_tree.c)
mmverify_add_subject(tree_example ${tree_example})
if(NOT MMVERIFY_SANITIZE)
  # The harness of other people's codecs, on a right one and on a wrong one.
  set(corpus ${PROJECT_BINARY_DIR}/seeds/subject)
  add_test(NAME fuzz_subject_corpus COMMAND fuzz_subject_replay ${corpus})
  mmverify_add_planted(subject fuzz_subject_replay "fuzz_subject: tree.equals_spec: not Algorithm 1's bytes")
  set_tests_properties(fuzz_subject_corpus PROPERTIES ENVIRONMENT MMVERIFY_SUBJECT=${subjects_dir}/tree_example.so)
  set_tests_properties(fuzz_subject_finds_what_was_planted PROPERTIES ENVIRONMENT MMVERIFY_SUBJECT=${subjects_dir}/tree_merges_ut.so)
endif()
mmverify_add_part(right_tree ${tree_example} mmverify_subject_v1=right_tree)
mmverify_add_part(wrong_tree subjects/wrong_tree.cpp)
foreach(wrong merges_ut children_reversed takes_all refuses_its_own has_no_code pads_with_ones crash hang overrun underrun exits
    throws rounds counts_calls sees_room sees_threads writes_input unwritten asks_too_much reads_past writes_code unwritten_map
    changes_its_mind lookup_crashes lookup_unwritten lookup_reads_past point_throws encodes_only decodes_only points_only
    foreign_decoder foreign_encoder hangs_on_uo keeps_by_ends)
  mmverify_add_wrong(tree_${wrong} ${wrong} wrong_tree right_tree)
endforeach()
mmverify_add_part(several subjects/several.cpp)
foreach(wrong nothing old_header keeps_padding merges_ut_with_t promises_opaque reads_past_map leaves_unwritten loads_at_16
    keeps_without_format keeps_without_level)
  mmverify_add_wrong(several_${wrong} ${wrong} several right_tree mmverify::impl)
endforeach()

mmverify_add_tests(worker_place_test worker_place_test watch_test LIBRARIES mmverify::dock)
target_compile_definitions(worker_place_test PRIVATE MMVERIFY_SUBJECTS="${subjects_dir}"
  MMVERIFY_WORKER_PROGRAM="$<TARGET_FILE:mmverify-worker>")
add_dependencies(worker_place_test mmverify-worker subject_tree_example)

# And of square maps and their blocks.
set(vq_example ${PROJECT_SOURCE_DIR}/examples/subject_vq/subject_vq.c)
mmverify_add_subject(vq_example ${vq_example})
mmverify_add_part(right_vq ${vq_example} mmverify_subject_v1=right_vq)
mmverify_add_part(wrong_vq subjects/wrong_vq.cpp)
foreach(wrong y_downwards turns_the_other_way last_region_of_br opaque_for_transparent checks_nothing state_3 promises_to_keep decoder_reads_past
    decoder_unwritten region_crashes region_loads_at_16 encoder_overrun encoder_counts_calls encoder_throws decodes_only encodes_only vq4_only old_header)
  mmverify_add_wrong(vq_${wrong} ${wrong} wrong_vq right_vq)
endforeach()

# And of a scene's maps.
set(dag_example ${PROJECT_SOURCE_DIR}/examples/subject_dag/subject_dag.c)
mmverify_add_subject(dag_example ${dag_example})
mmverify_add_part(right_dag ${dag_example} mmverify_subject_v1=right_dag)
mmverify_add_part(wrong_dag subjects/wrong_dag.cpp)
foreach(wrong merges_near forgets_the_second padding_set looks_in_the_first encoder_throws encoder_counts_calls lookup_crashes
    decodes_only encodes_only looks_up_only promises_the_container old_header looks_for_257_in_the_first numbers_of_16_bits
    decoder_reads_past_its_code answers_no_scene answers_by_the_last_code)
  mmverify_add_wrong(dag_${wrong} ${wrong} wrong_dag right_dag)
endforeach()

# And of traversal.
set(traverse_example ${PROJECT_SOURCE_DIR}/examples/subject_traverse/subject_traverse.c)
mmverify_add_subject(traverse_example ${traverse_example})
mmverify_add_part(right_traverse ${traverse_example} mmverify_subject_v1=right_traverse)
mmverify_add_part(wrong_traverse subjects/wrong_traverse.cpp)
foreach(wrong instance_after_ray khr_query_forgets_2_state opaque_fills_holes outcome_3 crash throws unwritten counts_calls old_header
    geometry_of_the_first_of_four blend_crash blend_unwritten blend_truncates blend_wraps blend_chains hits_as_met
    hits_beside_blend hits_throw hits_unwritten blend_guesses_b_of_the_value blend_knows_no_b_without_r hits_guess_g_of_the_payload)
  mmverify_add_wrong(traverse_${wrong} ${wrong} wrong_traverse right_traverse)
endforeach()
mmverify_add_subject(lockstep_blend subjects/lockstep_blend.c)

# And of arrays.
set(array_example ${PROJECT_SOURCE_DIR}/examples/subject_array/subject_array.c)
mmverify_add_subject(array_example ${array_example})
mmverify_add_part(right_array ${array_example} mmverify_subject_v1=right_array)
mmverify_add_part(wrong_array subjects/wrong_array.cpp)
foreach(wrong merges_known one_format one_histogram base_on_special order_from_level_2 less_or_equal minus_5_everywhere state_4
    refuses_two says_more_bytes takes_maps_in_a_row wants_ascending_maps crash throws overrun counts_calls resolves_only old_header one_base_a_batch)
  mmverify_add_wrong(array_${wrong} ${wrong} wrong_array right_array)
endforeach()

set(array_changes_example ${PROJECT_SOURCE_DIR}/examples/subject_array/subject_array_changes.c)
mmverify_add_subject(array_changes_example ${array_changes_example})
mmverify_add_part(right_array_changes ${array_changes_example} mmverify_subject_v1=right_array_changes)
mmverify_add_part(wrong_array_changes subjects/wrong_array_changes.cpp)
foreach(wrong compact_drops_nothing compact_refuses compact_keeps_the_base compact_overruns reorder_does_nothing
    concatenate_leaves_the_base concatenate_leaves_the_offsets load_lets_bytes_behind_pass load_forgets_signs emulate_by_majority
    saves_alone compact_empties_level_2 reorder_empties_level_2 concatenate_empties_level_2 load_refuses_level_2
    load_refuses_no_array reorder_forgets_the_third)
  mmverify_add_wrong(array_changes_${wrong} ${wrong} wrong_array_changes right_array_changes)
endforeach()

# And of attribute maps.
set(attribute_example ${PROJECT_SOURCE_DIR}/examples/subject_attribute/subject_attribute.c)
mmverify_add_subject(attribute_example ${attribute_example})
mmverify_add_part(right_attribute ${attribute_example} mmverify_subject_v1=right_attribute)
mmverify_add_part(wrong_attribute subjects/wrong_attribute.cpp)
foreach(wrong bird_vertex_twice w_minor_row_turned curve_as_rows half_is_2 figure_4_cycle lower_for_upper rounded_carry
    lower_weights_on_upper towards_the_middle halves_go_up index_beyond crash unwritten order_of_before weights_count_calls
    vertex_without_level old_header indices_only second_child_is_grey second_child_without_alpha_is_black
    bird_vertex_at_12)
  mmverify_add_wrong(attribute_${wrong} ${wrong} wrong_attribute right_attribute)
endforeach()
mmverify_add_subject(lockstep_face_mip subjects/lockstep_face_mip.c)

# And of their bakers.
set(attribute_bake_example ${PROJECT_SOURCE_DIR}/examples/subject_attribute_bake/subject_attribute_bake.c)
mmverify_add_subject(attribute_bake_example ${attribute_bake_example})
target_link_libraries(subject_attribute_bake_example PRIVATE m)
mmverify_add_part(right_attribute_bake ${attribute_bake_example} mmverify_subject_v1=right_attribute_bake)
mmverify_add_part(wrong_attribute_bake subjects/wrong_attribute_bake.cpp)
foreach(wrong srgb_as_codes black_border mirror_repeats wraps_exchanged centres_at_corners coordinates_in_8_bits_at_5 rows_from_below
    declines_all declines_borders two_codes_off_at_4 one_code_off unwritten reads_past overrun exact_by_its_word tolerance_above_16
    clamps_srgb_only vertices_only old_header)
  mmverify_add_wrong(attribute_bake_${wrong} ${wrong} wrong_attribute_bake right_attribute_bake m)
endforeach()

# And of shapes that are cut again and again.
set(subdivision_example ${PROJECT_SOURCE_DIR}/examples/subject_subdivision/subject_subdivision.c)
mmverify_add_subject(subdivision_example ${subdivision_example})
mmverify_add_part(right_subdivision ${subdivision_example} mmverify_subject_v1=right_subdivision)
mmverify_add_part(wrong_subdivision subjects/wrong_subdivision.cpp)
foreach(wrong crash ignores_z hilbert_is_morton diagonal_goes_back turns_a_cell_of_nine corners_only)
  mmverify_add_wrong(subdivision_${wrong} ${wrong} wrong_subdivision right_subdivision)
endforeach()

# And of bakers.
set(bake_example ${PROJECT_SOURCE_DIR}/examples/subject_bake/subject_bake.c)
mmverify_add_subject(bake_example ${bake_example})
target_link_libraries(subject_bake_example PRIVATE m)
mmverify_add_part(right_bake ${bake_example} mmverify_subject_v1=right_bake)
mmverify_add_part(wrong_bake subjects/wrong_bake.cpp)
foreach(wrong settles_all rows_from_below pads_with_ones promises_the_centroid all_unknown reads_past overrun unwritten counts_calls throws
    changes_its_mind crashes_on_some crashes_and_is_wrong declines_borders declines_all old_header keeps_by_first_row)
  mmverify_add_wrong(bake_${wrong} ${wrong} wrong_bake right_bake m)
endforeach()
# And of bakers of meshes, from the example's baker or this library's.
set(mesh_example ${PROJECT_SOURCE_DIR}/examples/subject_mesh/subject_mesh.c)
mmverify_add_subject(mesh_example ${mesh_example})
target_compile_definitions(subject_mesh_example PRIVATE baker=right_bake)
target_link_libraries(subject_mesh_example PRIVATE right_bake m)
mmverify_add_part(right_mesh ${mesh_example} baker=right_c_face mmverify_subject_v1=right_mesh)
mmverify_add_part(wrong_mesh subjects/wrong_mesh.cpp)
foreach(wrong nothing shares_by_quarters shares_turned shares_rewound special_of_unbaked overlaps counts_triangles pads_with_ones
    takes_one_level chooses_levels chooses_levels_untold declines_levels bakes_triangles_too crash throws reads_past overrun
    counts_calls old_header)
  mmverify_add_wrong(mesh_${wrong} ${wrong} wrong_mesh right_mesh right_c_face mmverify::impl)
endforeach()
mmverify_add_part(declared_bake subjects/declared_bake.cpp)
foreach(wrong nothing meets_the_cutoff cutoff_half_a_slack_off all_unknowns_opaque one_unknown_transparent upside_down says_nothing)
  mmverify_add_wrong(bake_declares_${wrong} ${wrong} declared_bake mmverify::impl)
endforeach()

# And of several topics, each right wherever a law asks.
mmverify_add_part(forgetful subjects/forgetful.cpp)
foreach(wrong decide_without_flag_1024 blend_without_operation encode_without_format decode_without_format
    lookup_without_format vertex_without_order decide_tail_of_16 lookup_tail_of_16 mip_tail_of_4 mip_after_13)
  mmverify_add_wrong(forgetful_${wrong} ${wrong} forgetful right_traverse right_tree right_attribute)
endforeach()
mmverify_add_part(touchy subjects/touchy.cpp)
foreach(wrong nothing decide_writes_behind decode_writes_behind decide_keeps_answers encode_adds_to_zero place_keeps_j
    encode_ends_in_a_word encode_asks_for_twice decode_at_13 place_descending place_by_twos decide_runs_of_256
    place_shares_order lookup_shares_level)
  mmverify_add_wrong(touchy_${wrong} ${wrong} touchy right_traverse right_tree right_attribute)
endforeach()
mmverify_add_part(careless subjects/careless.cpp)
foreach(wrong decide_errno_range decide_errno_invalid decide_flags decide_characters decide_deep_stack decide_shallow_stack
    decide_x87 decide_mmx decide_signals decide_changes_struct decide_takes_struct_back decide_another_time decide_for_2
    decide_for_19 decide_below_4_gib decide_one_array decide_writes_words decide_wide decode_reads_on decode_below_2_gib
    decode_errno decode_writes_words decimate_one_array encode_above_64_kib encode_above_1_mib)
  mmverify_add_wrong(touchy_${wrong} ${wrong} careless right_traverse right_tree right_attribute)
endforeach()
