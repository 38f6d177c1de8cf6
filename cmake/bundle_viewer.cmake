# Makes one script of three.js and the viewer's modules, and a C++ source with its SHA-256:
# cmake -DTHREE_JS=... -DLICENSE=... -DMODULES=a.js,b.js -DSCRIPT=... -DHASH=... -P bundle_viewer.cmake
#
# The modules stand in the order in which they need each other, what they define differs in name, and each import is one
# line: without imports and exports, and in one function, they are one script. Comments that have lines of their own, and
# indentation, are left out.
file(READ ${LICENSE} license)
set(is_complete false)
if(THREE_JS)
  file(READ ${THREE_JS} three)
  set(is_complete true)
endif()
set(script "/*\n${license}*/\n${three}\n(() => {\n'use strict';\n")
string(REPLACE "," ";" modules "${MODULES}")
foreach(module IN LISTS modules)
  file(READ ${module} text)
  string(REGEX REPLACE "\nimport [^\n]*" "" text "${text}")
  string(REGEX REPLACE "\nexport " "\n" text "${text}")
  string(REGEX REPLACE "\n */[/*][^\n]*" "" text "\n${text}")
  string(REGEX REPLACE "\n *\\* [^\n]*|\n *\\*/" "" text "${text}")
  string(REGEX REPLACE "\n +" "\n" text "${text}")
  string(APPEND script "${text}")
endforeach()
file(WRITE ${SCRIPT} "${script}})();\n")
file(SHA256 ${SCRIPT} hash)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${hash}")
file(WRITE ${HASH} "#include \"viewer/shipped_viewer.h\"
namespace CGAL::Shape_correspondence::IO {
const unsigned char shipped_viewer_hash[] = {${bytes}};
const std::size_t shipped_viewer_hash_size = 32;
const bool shipped_viewer_is_complete = ${is_complete};
} // namespace CGAL::Shape_correspondence::IO
")
