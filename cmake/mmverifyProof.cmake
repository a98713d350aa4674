# mmverify_add_proof(NAME SUBJECT TARGET [LAWS LAW...] [LEVELS A..B])
#
# Adds the test NAME: mmverify prove of the library that TARGET builds, a MODULE or SHARED library that exports
# mmverify_subject_v1.  LAWS: laws or topics, as `mmverify list` names them; all where none is given.  The test fails where a law is
# refuted, the library breaks, or no law applies to it.  Its results, as JSON and as JUnit, are NAME.json and NAME.xml in the
# build folder: what `mmverify gate` and a CI system read.
function(mmverify_add_proof name)
  cmake_parse_arguments(PARSE_ARGV 1 proof "" "SUBJECT;LEVELS" "LAWS")
  # A keyword without a value is what an unset variable comes to.
  if(NOT proof_SUBJECT OR NOT TARGET "${proof_SUBJECT}" OR proof_UNPARSED_ARGUMENTS OR proof_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "mmverify_add_proof(NAME SUBJECT TARGET [LAWS LAW...] [LEVELS A..B])")
  endif()
  set(levels "")
  if(proof_LEVELS)
    set(levels --levels ${proof_LEVELS})
  endif()
  add_test(NAME ${name}
    COMMAND mmverify::mmverify prove ${proof_LAWS} --subject $<TARGET_FILE:${proof_SUBJECT}> ${levels} --no-mutants --quiet
            --json ${CMAKE_CURRENT_BINARY_DIR}/${name}.json --junit ${CMAKE_CURRENT_BINARY_DIR}/${name}.xml)
endfunction()
