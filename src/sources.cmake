# The engine's sources, in two lists: KARCHER_FAST_SOURCES and KARCHER_SMALL_SOURCES.
#
# What runs once a sample or a vertex is made fast, what runs once a curve or a mesh is made small (in
# WebAssembly only, as a page loads it). A room is one of the two as a whole, but for the files named
# below. Nothing is told from a file's name, so nothing is lost when it changes: a source in no room,
# and a named file that is not there, end the configuration.
set(KARCHER_FAST_ROOMS
  intrinsic distance rcm curves/trace)
set(KARCHER_SMALL_ROOMS
  mesh curves curves/spec curves/polygon curves/query curves/refine)
set(KARCHER_FAST_IN_SMALL_ROOMS
  curves/polygon/piece_boxes.cpp
  curves/spec/segment_basis.cpp
  mesh/obj_lines.cpp
  mesh/surface_point.cpp)
set(KARCHER_SMALL_IN_FAST_ROOMS
  curves/trace/branches.cpp
  curves/trace/bridge.cpp
  curves/trace/edge_crossings.cpp
  curves/trace/joined_path.cpp
  curves/trace/piece.cpp
  curves/trace/polyline.cpp
  curves/trace/sample_status.cpp
  curves/trace/sampling.cpp
  curves/trace/segment.cpp
  distance/distance_solver.cpp
  distance/edge_dijkstra.cpp
  distance/edge_midpoints.cpp
  distance/fast_trial.cpp
  distance/find_path.cpp
  distance/geodesic_line.cpp
  distance/graph_distance.cpp
  distance/page_pool.cpp
  distance/ring_graph.cpp
  distance/shortest_path.cpp
  distance/source_images.cpp
  distance/source_vectors.cpp
  distance/tangent_maps.cpp
  distance/visibility.cpp
  distance/watched_target.cpp
  distance/waypoints.cpp
  intrinsic/geometry.cpp
  intrinsic/local_path.cpp
  intrinsic/straightest.cpp
  intrinsic/strip_search.cpp
  intrinsic/strip_shortening.cpp
  intrinsic/tangent.cpp
  intrinsic/vertex_fans.cpp
  rcm/certificate.cpp
  rcm/energy_ring.cpp
  rcm/exact_minimum.cpp
  rcm/field_options.cpp
  rcm/field_set.cpp
  rcm/gradient_operator.cpp
  rcm/mean.cpp
  rcm/mean_of_many.cpp
  rcm/mean_weights.cpp
  rcm/newton_center.cpp
  rcm/one_source_energy.cpp
  rcm/point_field.cpp
  rcm/surface.cpp
  rcm/summed_field.cpp
  rcm/uniqueness.cpp)
# Libraries of their own.
set(KARCHER_OTHER_ROOMS
  peers)

# Sets `sources` to the files of the rooms without those of `exceptions`, each of which must be there.
function(karcher_sources sources rooms exceptions)
  set(found)
  foreach(room ${rooms})
    file(GLOB files RELATIVE ${CMAKE_CURRENT_FUNCTION_LIST_DIR} CONFIGURE_DEPENDS
      ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/${room}/*.cpp)
    if(NOT files)
      message(FATAL_ERROR "src/sources.cmake names the room src/${room}, which has no source")
    endif()
    list(APPEND found ${files})
  endforeach()
  foreach(exception ${exceptions})
    if(NOT exception IN_LIST found)
      message(FATAL_ERROR
        "src/sources.cmake names src/${exception}, which is not among the sources of: ${rooms}")
    endif()
    list(REMOVE_ITEM found ${exception})
  endforeach()
  set(${sources} ${found} PARENT_SCOPE)
endfunction()

karcher_sources(KARCHER_FAST_SOURCES "${KARCHER_FAST_ROOMS}" "${KARCHER_SMALL_IN_FAST_ROOMS}")
karcher_sources(KARCHER_SMALL_SOURCES "${KARCHER_SMALL_ROOMS}" "${KARCHER_FAST_IN_SMALL_ROOMS}")
karcher_sources(KARCHER_OTHER_SOURCES "${KARCHER_OTHER_ROOMS}" "")
list(APPEND KARCHER_FAST_SOURCES ${KARCHER_FAST_IN_SMALL_ROOMS})
list(APPEND KARCHER_SMALL_SOURCES ${KARCHER_SMALL_IN_FAST_ROOMS})

file(GLOB_RECURSE KARCHER_UNLISTED RELATIVE ${CMAKE_CURRENT_LIST_DIR} CONFIGURE_DEPENDS
  ${CMAKE_CURRENT_LIST_DIR}/*.cpp)
set(KARCHER_LISTED ${KARCHER_FAST_SOURCES} ${KARCHER_SMALL_SOURCES} ${KARCHER_OTHER_SOURCES})
list(LENGTH KARCHER_LISTED KARCHER_LISTED_COUNT)
list(REMOVE_ITEM KARCHER_UNLISTED ${KARCHER_LISTED})
if(KARCHER_UNLISTED)
  message(FATAL_ERROR "src/sources.cmake names no room of: ${KARCHER_UNLISTED}")
endif()
list(REMOVE_DUPLICATES KARCHER_LISTED)
list(LENGTH KARCHER_LISTED KARCHER_UNIQUE_COUNT)
if(NOT KARCHER_UNIQUE_COUNT EQUAL KARCHER_LISTED_COUNT)
  message(FATAL_ERROR "src/sources.cmake names a room twice")
endif()
list(TRANSFORM KARCHER_FAST_SOURCES PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
list(TRANSFORM KARCHER_SMALL_SOURCES PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
