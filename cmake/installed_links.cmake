# After the documents are installed: a relative link of theirs to a file that is not installed becomes plain words, and a
# page that names files of the source tree says under its title where they are.
# Domain: documents_folder, the folder of the documents.  Run by cmake/install.cmake.
string(ASCII 1 mark)  # in the place of ](, since CMake takes brackets for parts of lists
file(GLOB_RECURSE pages "${documents_folder}/*.md")
foreach(page IN LISTS pages)
  file(READ "${page}" text)
  get_filename_component(here "${page}" DIRECTORY)
  string(REPLACE "](" "${mark}" marked "${text}")
  string(REGEX MATCHALL "${mark}[^()\n ]+\\)" links "${marked}")
  list(REMOVE_DUPLICATES links)
  foreach(link IN LISTS links)
    string(REGEX REPLACE "^${mark}([^#)]*).*$" "\\1" path "${link}")
    if(path STREQUAL "" OR path MATCHES "^[a-z]+:" OR EXISTS "${here}/${path}")
      continue()
    endif()
    string(REGEX REPLACE "([][+.*()^$?\\])" "\\\\\\1" dead "${link}")
    string(REGEX REPLACE "\\[([^][]*)${dead}" "\\1" marked "${marked}")
  endforeach()
  string(REPLACE "${mark}" "](" marked "${marked}")
  if(marked MATCHES "(\\./run |[` (](bench|cli|cmake|delivery|display|fuzz|impl|proofs|scene|scripts|spec|subjects|tests)/[a-z])"
     AND page MATCHES "/docs/[^/]*$" AND NOT marked MATCHES "source tree, which no package installs")
    string(REGEX REPLACE "^(# [^\n]*\n)"
      "\\1\n`./run`, and files in folders such as `spec/` and `scripts/`, are in mmverify's source tree, which no package installs.\n" marked "${marked}")
  endif()
  if(NOT marked STREQUAL text)
    file(WRITE "${page}" "${marked}")
  endif()
endforeach()
