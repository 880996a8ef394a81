/* The formats as the mutator sees them. A word is here when no seed has it. */
#include "mutate.h"

#include <string.h>

static const fuzz_grammar grammars[] = {
    {.name = "offsets", .end = '\n', .quote = '"', .words = "x y z s t units feet in mm - --"},
    {.name = "points", .end = '\n', .quote = '"', .words = "x y z u v group"},
    {.name = "aerofoil", .end = '\n'},
    {.name = "iges", .end = '\n', .has_columns = true},
    {.name = "step",
     .end = ';',
     .reference = '#',
     .quote = '\'',
     .words = ".T. .F. .U. $ * ENDSEC DATA HEADER .MILLI. .METRE. .RADIAN. MAPPED_ITEM "
              "ORIENTED_EDGE EDGE_CURVE VERTEX_POINT VERTEX_LOOP FACE_BOUND ADVANCED_FACE "
              "CLOSED_SHELL OPEN_SHELL MANIFOLD_SOLID_BREP PLANE LINE CIRCLE POLYLINE "
              "CARTESIAN_POINT DIRECTION SPHERICAL_SURFACE DEGENERATE_TOROIDAL_SURFACE"},
    {.name = "g2", .end = '\n', .words = "0 1 100 200 210 700"},
    {.name = "dxf",
     .end = '\n',
     .words = "SECTION ENDSEC HEADER TABLES BLOCKS ENTITIES EOF $INSUNITS LINE ARC CIRCLE "
              "ELLIPSE SPLINE LWPOLYLINE POLYLINE VERTEX SEQEND POINT 3DFACE INSERT BLOCK "
              "ENDBLK ATTRIB LAYER"},
    {.name = "svg",
     .end = '>',
     .is_glued = true,
     .words =
         "svg g path rect circle ellipse line polyline polygon defs use symbol transform "
         "matrix translate scale rotate skewX skewY viewBox width height mm cm in pt pc px "
         "M L H V C S Q T A Z m l h v c s q t a z"},
    {.name = "stl",
     .end = '\n',
     .header_end = "", /* of three numbers each from the 80th byte on, or all is text */
     .words = "solid facet normal outer loop vertex endloop endfacet endsolid"},
    {.name = "ply",
     .end = '\n',
     .header_end = "end_header\n",
     .words = "ply format ascii binary_little_endian binary_big_endian element vertex face "
              "property list char uchar short ushort int uint float double x y z nx ny nz red "
              "green blue alpha vertex_indices vertex_index end_header"},
    {.name = "obj",
     .end = '\n',
     .words = "v vt vn vp f l p o g s usemtl mtllib deg bmat step cstype rat bmatrix bezier "
              "bspline cardinal taylor curv curv2 surf parm trim hole scrv sp end con / \\"},
    {.name = "off", .end = '\n', .words = "OFF COFF NOFF STOFF 4OFF nOFF BINARY"},
    {.name = "pcd",
     .end = '\n',
     .header_end = "DATA binary",
     .words = "VERSION FIELDS SIZE TYPE COUNT WIDTH HEIGHT VIEWPOINT POINTS DATA ascii binary "
              "binary_compressed x y z rgb rgba F I U"},
    {.name = "ftm", .end = '\n', .words = "FREE!ship 2.6"},
    {.name = "design",
     .end = '\n',
     .quote = '"',
     .words = "features outputs of - : [ ] { } & *"},
};

const fuzz_grammar *fuzz_grammar_of(const char *name)
{
    for (size_t i = 0; i < sizeof grammars / sizeof grammars[0]; i++)
        if (strcmp(grammars[i].name, name) == 0)
            return &grammars[i];
    return NULL;
}
