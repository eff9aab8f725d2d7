# The layering of the tree: what each room may include, and everything else fails. Read from the includes, so that nobody has to remember it.
# Run as a test: cmake -DROOT=... -P tests/arrows.cmake. README's table of rooms is made of the same lines: add -DWRITE=ON to write it anew.

cmake_minimum_required(VERSION 3.25)

get_filename_component(ROOT "${ROOT}" ABSOLUTE)
set(rooms "")

# room(FOLDER [USES other rooms] [LIBRARIES headers]): what the files of a folder may include, besides their own folder and the standard
# library. A file belongs to the deepest room that holds it. A library is the beginning of its headers' names.
function(room folder)
  cmake_parse_arguments(R "" "" "USES;LIBRARIES" ${ARGN})
  list(APPEND rooms ${folder})
  set(rooms ${rooms} PARENT_SCOPE)
  set(uses_${folder} ${R_USES} PARENT_SCOPE)
  set(libraries_${folder} ${R_LIBRARIES} PARENT_SCOPE)
endfunction()

set(model runtime/model)
set(posix fcntl.h poll.h sys/ time.h unistd.h)

# The guide: the standard library, GLM and fmt.
room(runtime/model LIBRARIES glm/)
room(runtime/schema USES ${model})
room(runtime/path USES ${model})
room(runtime/motion USES ${model} LIBRARIES glm/)
room(runtime/crowd USES ${model} runtime/path)
room(runtime/input USES ${model} LIBRARIES fmt/)
room(runtime/scene USES ${model} runtime/path LIBRARIES glm/)
room(runtime/interface USES ${model} runtime/path runtime/scene LIBRARIES fmt/)
room(runtime/plan USES ${model} runtime/path runtime/motion runtime/crowd runtime/interface)
room(runtime/guide USES ${model} runtime/path runtime/motion runtime/crowd runtime/input runtime/scene runtime/interface runtime/plan)
room(runtime/release USES ${model} LIBRARIES fmt/)
room(runtime/kiosk
  USES ${model} runtime/schema runtime/input runtime/scene runtime/interface runtime/plan runtime/guide config platform platform/clock platform/file
       platform/gles platform/headless platform/hid platform/image platform/journal platform/kms platform/pango platform/pin platform/service
       platform/signature platform/sqlite platform/terminal platform/x11
  LIBRARIES fmt/ link.h malloc.h termios.h ${posix})

room(runtime/update
  USES ${model} runtime/release runtime/schema config platform/file platform/https platform/signature platform/sqlite platform/terminal
  LIBRARIES fmt/ grp.h nlohmann/ spawn.h ${posix})

# The edges: one system interface each.
room(platform)
room(platform/clock LIBRARIES ${posix})
room(platform/file USES ${model} LIBRARIES fmt/ ${posix})
room(platform/signature USES ${model} platform/file LIBRARIES fmt/ sodium/)
room(platform/https USES ${model} platform/file LIBRARIES fmt/ curl/ netinet/ openssl/ ${posix})
room(platform/terminal USES ${model} LIBRARIES fmt/ CLI/ unistd.h)
room(platform/journal LIBRARIES ${posix})
room(platform/service USES ${model} LIBRARIES ${posix})
room(platform/egl USES ${model} LIBRARIES fmt/ EGL/)
room(platform/gles USES ${model} runtime/scene platform platform/image LIBRARIES fmt/ EGL/ GLES2/ GLES3/)
room(platform/headless USES ${model} platform platform/egl platform/image LIBRARIES fmt/ EGL/ GLES3/)
room(platform/hid USES ${model} runtime/input platform platform/file platform/journal LIBRARIES fmt/ hidapi/ linux/ ${posix})
room(platform/image USES ${model} LIBRARIES fmt/ spng.h jpeglib.h ${posix})
room(platform/kms USES ${model} platform platform/egl platform/journal LIBRARIES fmt/ EGL/ drm.h drm_fourcc.h gbm.h linux/ xf86drm ${posix})
room(platform/pango USES ${model} runtime/interface platform LIBRARIES pango/)
room(platform/pin USES ${model} LIBRARIES sodium/)
room(platform/sqlite USES ${model} runtime/schema platform platform/signature LIBRARIES fmt/ sodium sqlite3.h)
room(platform/x11 USES ${model} runtime/input platform platform/clock platform/egl LIBRARIES fmt/ EGL/ xcb/ ${posix})
room(config USES ${model} platform/file platform/terminal LIBRARIES fmt/ nlohmann/ toml++/)

# The compiler. CGAL is a private matter of the rooms that build diagrams and triangulations.
room(content USES ${model} platform/file)
room(content/import USES ${model} platform platform/file content LIBRARIES expat.h fmt/ geos_c.h gif_lib.h glm/ iconv.h libheif/ nlohmann/ protozero/ pugixml toml++/ webp/ zip.h zlib.h)
room(content/floor USES ${model} content content/import LIBRARIES fmt/ CGAL/)
room(content/motion USES ${model} runtime/motion content content/import LIBRARIES fmt/)
room(content/gait USES ${model} content content/import LIBRARIES fmt/ glm/)
room(content/avatar USES ${model} content LIBRARIES glm/ meshoptimizer.h)
room(content/scenery USES ${model} content LIBRARIES CGAL/)
room(content/draw USES ${model} content LIBRARIES fmt/ cairo.h librsvg/)
room(content/film
  USES ${model} runtime/motion runtime/plan runtime/guide runtime/scene platform platform/gles platform/headless platform/image content/scenery LIBRARIES fmt/ webp/)
room(content/write USES ${model} runtime/schema platform/file platform/sqlite content LIBRARIES unistd.h fmt/ spawn.h sqlite3.h sys/)
room(content/compile
  USES ${model} runtime/path runtime/motion config platform platform/file platform/image platform/terminal content content/import content/floor
       content/motion content/avatar content/scenery
  LIBRARIES fmt/ cairo.h librsvg/ ${posix})
room(content/command
  USES ${model} runtime/schema runtime/path runtime/motion runtime/scene runtime/release config platform/file platform/image platform/signature
       platform/sqlite platform/terminal content content/import
       content/motion content/draw content/film content/write content/compile
  LIBRARIES fmt/ nlohmann/)

# The deepest room that holds a path; empty where there is none.
function(room_of path result)
  set(${result} "" PARENT_SCOPE)
  while(path MATCHES "/")
    get_filename_component(path "${path}" DIRECTORY)
    if(path IN_LIST rooms)
      set(${result} ${path} PARENT_SCOPE)
      return()
    endif()
  endwhile()
endfunction()

# Headers that are made while configuring lie beside the file that includes them.
set(made_headers schema_sql.h platform/gles/shaders.h)

set(failures "")
set(files "")
foreach(top runtime platform config content)
  file(GLOB_RECURSE found RELATIVE "${ROOT}" "${ROOT}/${top}/*.h" "${ROOT}/${top}/*.cpp")
  if(NOT found)
    message(FATAL_ERROR "arrows: there is no source in ${top}")
  endif()
  list(APPEND files ${found})
endforeach()
foreach(file ${files})
  room_of(${file} room)
  if(NOT room)
    string(APPEND failures "${file}: belongs to no room\n")
    continue()
  endif()
  file(STRINGS "${ROOT}/${file}" lines REGEX "^#include ")
  foreach(line ${lines})
    if(line MATCHES "^#include \"(.*)\"")
      set(header ${CMAKE_MATCH_1})
      room_of(${header} other)
      if(header IN_LIST made_headers OR other STREQUAL room OR other IN_LIST uses_${room})
        set(used_${room}_${other} TRUE)
        continue()
      endif()
    elseif(line MATCHES "^#include <([a-z_0-9]+)>")
      continue()
    elseif(line MATCHES "^#include <(.*)>")
      set(header ${CMAKE_MATCH_1})
      set(known FALSE)
      foreach(library ${libraries_${room}})
        string(FIND "${header}" "${library}" at)
        if(at EQUAL 0)
          set(known TRUE)
        endif()
      endforeach()
      if(known)
        continue()
      endif()
    endif()
    string(APPEND failures "${file}: ${line}\n")
  endforeach()
endforeach()
# An arrow that nobody needs any more is a door left open.
foreach(room ${rooms})
  foreach(other ${uses_${room}})
    if(NOT used_${room}_${other})
      string(APPEND failures "${room}: lists ${other} and does not use it\n")
    endif()
  endforeach()
endforeach()

# README's table: each room's own heading, and what it uses.
set(table "| Room | Is | Uses |\n| --- | --- | --- |\n")
foreach(room ${rooms})
  if(NOT EXISTS "${ROOT}/${room}/README.md")
    string(APPEND failures "${room}: has no README.md\n")
    continue()
  endif()
  file(STRINGS "${ROOT}/${room}/README.md" heading LIMIT_COUNT 1)
  if(NOT heading MATCHES "^# [^:]+: (.+)$")
    string(APPEND failures "${room}/README.md: does not begin with '# name: what it is'\n")
    continue()
  endif()
  set(what "${CMAKE_MATCH_1}")
  list(REMOVE_ITEM uses_${room} ${model})
  string(REPLACE ";" "`, `" uses "${uses_${room}}")
  if(uses)
    set(uses "`${uses}`")
  endif()
  string(APPEND table "| [${room}](${room}) | ${what} | ${uses} |\n")
endforeach()
set(begin "<!-- rooms: cmake -DROOT=. -DWRITE=ON -P tests/arrows.cmake -->\n")
set(end "<!-- end of rooms -->")
file(READ "${ROOT}/README.md" readme)
string(FIND "${readme}" "${begin}" first)
string(FIND "${readme}" "${end}" last)
if(first LESS 0 OR last LESS 0)
  message(FATAL_ERROR "arrows: README.md has no place for the table of rooms, between ${begin}and ${end}")
endif()
string(LENGTH "${begin}" length)
math(EXPR first "${first} + ${length}")
string(SUBSTRING "${readme}" 0 ${first} before)
string(SUBSTRING "${readme}" ${last} -1 after)
if(WRITE)
  file(WRITE "${ROOT}/README.md" "${before}${table}${after}")
elseif(NOT readme STREQUAL "${before}${table}${after}")
  string(APPEND failures "README.md: its table of rooms is not that of the arrows; write it anew with -DWRITE=ON\n")
endif()

if(failures)
  message(FATAL_ERROR "against the arrows of tests/arrows.cmake:\n${failures}")
endif()
message(STATUS "the arrows hold")
