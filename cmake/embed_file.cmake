# Writes a C++ source with the bytes of a file: cmake -DFILE=... -DOUTPUT=... -DNAME=... -DHEADER=... -P embed_file.cmake
file(READ ${FILE} hex HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
file(SIZE ${FILE} size)
file(WRITE ${OUTPUT} "#include \"${HEADER}\"
namespace CGAL::Shape_correspondence::IO {
const unsigned char ${NAME}[] = {${bytes}};
const std::size_t ${NAME}_size = ${size};
} // namespace CGAL::Shape_correspondence::IO
")
