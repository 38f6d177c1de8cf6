# Pages of concepts are called so, and say no header, as in CGAL's manuals; doxygen takes concepts for classes.
# cmake -D html=FOLDER -P name_concept_pages.cmake
cmake_minimum_required(VERSION 3.18)
file(GLOB pages ${html}/class*.html)
foreach(page ${pages})
  file(READ ${page} text)
  if(text MATCHES "<div class=\"concept\">")
    string(REPLACE " Class Reference" " Concept Reference" text "${text}")
    string(REGEX REPLACE "<p><code>#include [^\n]*</code></p>\n" "" text "${text}")
    file(WRITE ${page} "${text}")
  endif()
endforeach()
