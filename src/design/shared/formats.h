/* The words by which designs name the formats of files. */
#ifndef BAT_DESIGN_FORMATS_H
#define BAT_DESIGN_FORMATS_H

/* Those of batten_format, in its order. */
#define BAT_FORMAT_WORDS                                                                     \
    "auto offsets points aerofoil iges step dxf svg g-code g2 obj stl ply gltf 3mf pcd ftm " \
    "off"

#endif
