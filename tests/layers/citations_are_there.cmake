# Every page, heading and equation that sources, pages and messages name is there:
#
#   docs/models.md, [text](models.md#figures-of-merit)   the file, and the heading
#   models.md (3), docs/models.md (3), (4)               the equation of that number on that page
#   ![text](images/archive.png)                          the file
cmake_policy(VERSION 3.22)
set(problems "")

file(GLOB_RECURSE files
  ${SOURCE_DIR}/src/fathom/*.h ${SOURCE_DIR}/src/fathom/*.cc ${SOURCE_DIR}/problems/*.h
  ${SOURCE_DIR}/problems/*.cc ${SOURCE_DIR}/tools/*.cc ${SOURCE_DIR}/tools/*.h
  ${SOURCE_DIR}/tests/*.h ${SOURCE_DIR}/tests/*.cc ${SOURCE_DIR}/bench/*.cc
  ${SOURCE_DIR}/fuzz/*.cc ${SOURCE_DIR}/data/*.yaml ${SOURCE_DIR}/scripts/*.sh
  ${SOURCE_DIR}/docs/*.md ${SOURCE_DIR}/README.md ${SOURCE_DIR}/CONTRIBUTING.md)
list(FILTER files EXCLUDE REGEX "node_modules|^${SOURCE_DIR}/build/")

# The numbers of a page's equations: at the end of an indented line, or behind two spaces in one; a few
# stand in the text, as ". (11), (12)" behind a sentence.
file(GLOB pages ${SOURCE_DIR}/docs/*.md ${SOURCE_DIR}/README.md ${SOURCE_DIR}/CONTRIBUTING.md)
foreach(page IN LISTS pages)
  file(RELATIVE_PATH name ${SOURCE_DIR} ${page})
  file(READ ${page} text)
  string(REPLACE ";" "," text "${text}")
  string(REGEX MATCHALL "\n    [^\n]*" indented "${text}")
  set(equations_${name} "")
  foreach(line IN LISTS indented)
    string(REGEX MATCHALL "(  | of the run )\\([0-9]+[a-z]?\\)| \\([0-9]+[a-z]?\\)$" found "${line}")
    string(REGEX REPLACE "[^0-9a-z;]|of the run" "" found "${found}")
    list(APPEND equations_${name} ${found})
  endforeach()
  string(REGEX MATCHALL "\\. \\([0-9]+[a-z]?\\)(, \\([0-9]+[a-z]?\\))*\n" in_text "${text}")
  string(REGEX MATCHALL "[0-9]+[a-z]?" in_text "${in_text}")
  list(APPEND equations_${name} ${in_text})

  # The anchors of its headings, as GitHub makes them.
  string(REGEX MATCHALL "\n#+ [^\n]*" headings "\n${text}")
  set(anchors_${name} "")
  foreach(heading IN LISTS headings)
    string(REGEX REPLACE "^\n#+ " "" anchor "${heading}")
    string(TOLOWER "${anchor}" anchor)
    string(REGEX REPLACE "[^a-z0-9 _-]" "" anchor "${anchor}")
    string(REPLACE " " "-" anchor "${anchor}")
    list(APPEND anchors_${name} "${anchor}")
  endforeach()
endforeach()

foreach(file IN LISTS files)
  file(RELATIVE_PATH path ${SOURCE_DIR} ${file})
  get_filename_component(folder ${file} DIRECTORY)
  file(READ ${file} text)
  string(REPLACE ";" "," text "${text}")
  # Citations run on over the lines of a comment. CMake's lists end at brackets.
  string(REGEX REPLACE "\n *(//|#)? *" " " text "${text}")
  string(REPLACE "[" "<" text "${text}")
  string(REPLACE "]" ">" text "${text}")

  string(REGEX MATCHALL "docs/[a-z_]+\\.md" named "${text}")
  list(REMOVE_DUPLICATES named)
  foreach(page IN LISTS named)
    if(NOT EXISTS ${SOURCE_DIR}/${page})
      list(APPEND problems "${path}: there is no ${page}")
    endif()
  endforeach()

  string(REGEX MATCHALL "[a-z_]+\\.md\\)? \\([0-9]+[a-z]?\\)((,| and| to| or) \\([0-9]+[a-z]?\\))*" cited "${text}")
  list(REMOVE_DUPLICATES cited)
  foreach(citation IN LISTS cited)
    string(REGEX MATCH "^[a-z_]+\\.md" page "${citation}")
    if(NOT EXISTS ${SOURCE_DIR}/docs/${page})
      list(APPEND problems "${path}: there is no docs/${page}")
      continue()
    endif()
    string(REGEX MATCHALL "\\([0-9]+[a-z]?" numbers "${citation}")
    string(REPLACE "(" "" numbers "${numbers}")
    foreach(number IN LISTS numbers)
      if(NOT number IN_LIST equations_docs/${page})
        list(APPEND problems "${path}: docs/${page} has no equation (${number})")
      endif()
    endforeach()
  endforeach()

  if(path MATCHES "\\.md$")
    string(REGEX MATCHALL ">\\([^)]*\\)" links "${text}")
    list(REMOVE_DUPLICATES links)
    foreach(link IN LISTS links)
      string(REGEX REPLACE "^>\\(|\\)$" "" link "${link}")
      if(link MATCHES "^https?:" OR NOT link MATCHES "^[A-Za-z0-9_./#-]+$")
        continue()
      endif()
      string(REGEX REPLACE "#.*" "" target "${link}")
      if(target STREQUAL "")
        get_filename_component(target ${file} NAME)
      endif()
      if(NOT EXISTS ${folder}/${target})
        list(APPEND problems "${path}: links to ${target}, which is not there")
        continue()
      endif()
      if(link MATCHES "#(.*)")
        set(anchor ${CMAKE_MATCH_1})
        file(RELATIVE_PATH page ${SOURCE_DIR} ${folder}/${target})
        if(DEFINED anchors_${page} AND NOT anchor IN_LIST anchors_${page})
          list(APPEND problems "${path}: ${target} has no heading for #${anchor}")
        endif()
      endif()
    endforeach()
  endif()
endforeach()

if(problems)
  list(JOIN problems "\n  " shown)
  message(FATAL_ERROR "cited, but not there:\n  ${shown}")
endif()
