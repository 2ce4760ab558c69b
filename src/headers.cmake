cmake_policy(VERSION 3.24)

# Writes the headers of the library's users to TO/karcher: `karcher/karcher.h` and the headers that
# it includes. The engine includes its headers by their rooms ("mesh/error.h"). The written ones are
# included as "karcher/mesh/error.h", so that they do not clash with another library's headers.
#
# `read` becomes the list of the files that were read.
function(karcher_write_headers from to read)
  file(REMOVE_RECURSE "${to}/karcher")
  set(waiting karcher/karcher.h)
  set(known ${waiting})
  while(waiting)
    list(POP_FRONT waiting header)
    file(READ "${from}/${header}" text)
    string(REGEX MATCHALL "#include \"[^\"]+\"" includes "${text}")
    foreach(include IN LISTS includes)
      string(REGEX REPLACE "#include \"(.+)\"" "\\1" include "${include}")
      if(NOT include IN_LIST known)
        list(APPEND known ${include})
        list(APPEND waiting ${include})
      endif()
    endforeach()
    string(REGEX REPLACE "#include \"" "#include \"karcher/" text "${text}")
    string(REGEX REPLACE "^karcher/" "" place ${header})
    file(WRITE "${to}/karcher/${place}" "${text}")
  endwhile()
  list(TRANSFORM known PREPEND "${from}/")
  set(${read} "${known}" PARENT_SCOPE)
endfunction()
