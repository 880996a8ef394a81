/* A small whole file of every format that is read as text. */
#ifndef TESTS_EXCHANGE_EVERY_FORMAT_H
#define TESTS_EXCHANGE_EVERY_FORMAT_H
#include <batten/exchange.h>
#include <stdbool.h>

#define IGES_TEXT                                                                        \
    "hand-made                                                               S      1\n" \
    "1H,,1H;,1Hx,1Hx,1Hx,1Hx,32,38,6,308,15,1Hx,1.,2,2HMM,1,0.,              G      1\n" \
    "13H260101.000000,1E-6,9.,,,11,0,;                                       G      2\n" \
    "     110       1       0       0       0       0       0       000000000D      1\n" \
    "     110       0       0       1       0                                D      2\n" \
    "110,1.,2.5,3.,4.,5.,6.;                                                1P      1\n" \
    "S      1G      2D      2P      1                                        T      1\n"

#define STEP_BEGIN                                                                          \
    "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"                               \
    "FILE_NAME('s','',(''),(''),'','','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\n" \
    "DATA;\n"
#define STEP_CONTEXT                                                                       \
    "#90=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"                          \
    "#91=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"                          \
    "#93=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-6),#90,'','');\n"                \
    "#94=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#93))\n" \
    "GLOBAL_UNIT_ASSIGNED_CONTEXT((#90,#91))REPRESENTATION_CONTEXT('',''));\n"             \
    "#95=GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',(#96),#94);\n"            \
    "#96=GEOMETRIC_CURVE_SET('',(#4));\n"
#define STEP_END "ENDSEC;\nEND-ISO-10303-21;\n"

typedef struct {
    batten_format format;
    bool is_known; /* by its content, not only by being rows of numbers */
    bool has_end;  /* so that a cut shows */
    const char *text;
    /* A file as large as one likes: ^ is how often `again` comes, @ a number that rises. NULL
     * for none. */
    const char *before, *again, *after;
} every;

static const every every_format[] = {
    {BATTEN_FORMAT_OFFSET_TABLE, false, false,
     "station,x,y,z\n1,0,1.5,2\n1,0,2.5,3\n2,1,1,1\n2,1,2,2\n", "station,x,y,z\n",
     "@,@,1.5,1\n@,@,2,2\n", ""},
    {BATTEN_FORMAT_POINTS, false, false, "1 2 3\n4.5 5 6\n", "", "1 2 @.5\n", ""},
    {BATTEN_FORMAT_AEROFOIL, false, false, "RAE 1\n1.0 .01\n.5 .1\n0 0\n.4 -.05\n1 -.01\n",
     NULL, NULL, NULL},
    {BATTEN_FORMAT_IGES, true, true, IGES_TEXT, NULL, NULL, NULL},
    {BATTEN_FORMAT_STEP, true, true,
     STEP_BEGIN "#1=CARTESIAN_POINT('',(1.,2.,3.));\n#2=CARTESIAN_POINT('',(1.5,2.,4.));\n"
                "#4=POLYLINE('name',(#1,#2));\n" STEP_CONTEXT STEP_END,
     STEP_BEGIN "#1=CARTESIAN_POINT('',(1.,2.,3.));\n#2=CARTESIAN_POINT('',(1.5,2.,4.));\n"
                "#4=POLYLINE('name',(#1,#2));\n" STEP_CONTEXT "",
     "#@=CARTESIAN_POINT('',(1.,2.,@.));\n", STEP_END},
    {BATTEN_FORMAT_DXF, true, true,
     "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nkeel\n10\n1\n20\n2\n30\n3\n11\n3."
     "5\n21\n4\n31\n5\n0\n"
     "ENDSEC\n0\nEOF\n",
     "0\nSECTION\n2\nENTITIES\n", "0\nLINE\n8\nk@\n10\n1\n20\n@\n11\n3.5\n21\n4\n",
     "0\nENDSEC\n0\nEOF\n"},
    {BATTEN_FORMAT_SVG, true, true,
     "<svg width=\"10mm\" height=\"10mm\" viewBox=\"0 0 10 10\">\n<line x1=\"1\" y1=\"2.5\"\n"
     "x2=\"3\" y2=\"4\"/>\n</svg>\n",
     "<svg width=\"10mm\" height=\"10mm\" viewBox=\"0 0 10 10\">\n",
     "<g><line id=\"a@\" x1=\"1\" y1=\"2.5\" x2=\"3\" y2=\"@\"/></g>\n", "</svg>\n"},
    {BATTEN_FORMAT_G2, true, true, "100 1 0 0\n3 0\n3 3\n0 0 0 1 1 1\n0 0 0\n1 2.5 0\n2 0 0\n",
     "", "100 1 0 0\n3 0\n3 3\n0 0 0 1 1 1\n0 0 0\n1 2.5 0\n2 0 @\n", ""},
    {BATTEN_FORMAT_OBJ, true, false, "v 0 0 0\nv 1 0 0\nv 1 1.5 0\nf 1 2 3\n",
     "v 0 0 0\nv 1 0 0\nv 1 1.5 0\n", "g n@\nv 0 0 @\nf 1 2 3 -1\n", ""},
    {BATTEN_FORMAT_STL, true, true,
     "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1.5 0\n"
     "endloop\nendfacet\nendsolid s\n",
     "solid s\n",
     "facet normal 0 0 1\nouter loop\nvertex 0 0 @\nvertex 1 0 @\nvertex 0 1.5 @\n"
     "endloop\nendfacet\n",
     "endsolid s\n"},
    {BATTEN_FORMAT_PLY, true, true,
     "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
     "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
     "0 0 0\n1 0 0\n1 1.5 0\n3 0 1 2\n",
     "ply\nformat ascii 1.0\nelement vertex ^\nproperty float x\nproperty float y\n"
     "property float z\nend_header\n",
     "0 1.5 @\n", ""},
    {BATTEN_FORMAT_PCD, true, true,
     "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\n"
     "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n1 2 3\n1.5 2 3\n",
     "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH ^\nHEIGHT 1\n"
     "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS ^\nDATA ascii\n",
     "1.5 2 @\n", ""},
    {BATTEN_FORMAT_OFF, true, true, "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1.5 0\n3 0 1 2\n",
     "OFF\n^ 0 0\n", "0 1.5 @\n", ""},
    {BATTEN_FORMAT_FTM, true, true,
     "FREE!ship\n2.6\n1\n1\nSide\n3\n255\n1\n1\n1\n1\n1\n0\n0\n1\n171\n0\n"
     "4\n0 0 0\n1\n0\n0\n1 0 0\n1\n0\n0\n1 1 0\n1\n0\n0\n0 1 0.5\n1\n0\n0\n0\n0\n"
     "1\n4\n0\n1\n2\n3\n0\n0\n0\n",
     NULL, NULL, NULL},
};

/* What can be nested, again and again without an end. */
static const struct {
    batten_format format;
    const char *before, *open;
} nested[] = {
    {BATTEN_FORMAT_STEP, STEP_BEGIN "#1=CARTESIAN_POINT('',", "("},
    {BATTEN_FORMAT_STEP, STEP_BEGIN "#1=", "A("},
    {BATTEN_FORMAT_SVG, "<svg>", "<g>"},
    {BATTEN_FORMAT_SVG, "<svg><path transform=\"", "scale("},
    {BATTEN_FORMAT_DXF, "", "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\na\n"},
    {BATTEN_FORMAT_OBJ, "v 0 0 0\n", "g a\\\n"},
    {BATTEN_FORMAT_OBJ, "cstype bspline\n", "curv 0 1 \\\n"},
    {BATTEN_FORMAT_STL, "", "solid "},
    {BATTEN_FORMAT_G2, "", "210 1 0 0\n"},
    {BATTEN_FORMAT_OFFSET_TABLE, "", "\"\"\"("},
};

#endif
