# Writes OUTPUT: shader_table(), every file of shaders/ as a raw string, so that quotes and semicolons survive.
# Editing, adding or removing a shader configures and builds again.
function(drape_embed_shaders output)
    file(GLOB files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/shaders/*)
    set(rows "")
    foreach(file IN LISTS files)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
        get_filename_component(name "${file}" NAME)
        file(READ "${file}" text)
        string(APPEND rows "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
    endforeach()
    file(WRITE "${output}.new" "// Written by embed_shaders.cmake from shaders/; edit those.
#include \"render/shader_table.h\"

namespace drape {

static constexpr ShaderFile table[] = {
${rows}};

std::span<const ShaderFile> shader_table() { return table; }

}  // namespace drape
")
    configure_file("${output}.new" "${output}" COPYONLY)
endfunction()
