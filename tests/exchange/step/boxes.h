/* STEP files for the tests of the reader: boxes in all the ways a file can turn things. */
#ifndef TESTS_EXCHANGE_STEP_BOXES_H
#define TESTS_EXCHANGE_STEP_BOXES_H
#include <stdarg.h>

#include "exchange/reading.h"

/* What is turned, and turned back elsewhere, so that the shape stays. */
enum {
    BOX_PLANES = 1, /* planes look inwards, same_sense is .F. */
    BOX_BOUNDS = 2, /* loops run against their faces, bounds say .F. */
    BOX_EDGES = 4,  /* edges run the other way, oriented edges are turned */
    BOX_LINES = 8,  /* curves run against their edges, same_sense is .F. */
    BOX_SHELL = 16, /* all faces look inwards, in an ORIENTED_CLOSED_SHELL .F. */
    BOX_FACES = 32, /* faces look inwards, in ORIENTED_FACEs .F. */
    BOX_ALL = 64
};

/* A text that grows in memory that never fails. */
typedef struct {
    char *bytes;
    size_t length, capacity;
} box_text;

__attribute__((format(printf, 2, 3))) static inline void box_add(box_text *text,
                                                                 const char *format, ...)
{
    char line[1024];
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    const bool is_long = length >= (int)sizeof line; /* then it is the format itself */
    const char *bytes = is_long ? format : line;
    const size_t more = strlen(bytes);
    if (text->length + more >= text->capacity) {
        char *larger = test_array(2 * (text->capacity + more) + 1, 1);
        if (text->length)
            memcpy(larger, text->bytes, text->length);
        text->bytes = larger;
        text->capacity = 2 * (text->capacity + more) + 1;
    }
    memcpy(text->bytes + text->length, bytes, more + 1);
    text->length += more;
}

static inline box_text *box_begin(box_text *text)
{
    *text = (box_text){.length = 0};
    box_add(text, "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
                  "FILE_NAME('t','2026-11-21T10:00:00',(''),(''),'','','');\n"
                  "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n");
    return text;
}

/* The file, given back when the test ends. */
static inline const char *box_end(box_text *text)
{
    box_add(text, "ENDSEC;\nEND-ISO-10303-21;\n");
    return text->bytes;
}

/* Context #`id`, its units #`id` + 1 .. + 4, which are mm and radian, accurate to 1e-6. */
static inline void box_context(box_text *text, int id)
{
    box_add(text,
            "#%d=(GEOMETRIC_REPRESENTATION_CONTEXT(3)"
            "GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#%d))"
            "GLOBAL_UNIT_ASSIGNED_CONTEXT((#%d,#%d,#%d))REPRESENTATION_CONTEXT('',''));\n",
            id, id + 4, id + 1, id + 2, id + 3);
    box_add(text, "#%d=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n", id + 1);
    box_add(text, "#%d=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n", id + 2);
    box_add(text, "#%d=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());\n", id + 3);
    box_add(text, "#%d=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-6),#%d,'','');\n",
            id + 4, id + 1);
}

/* A placement #id with the point and directions #id + 1 .. + 3. */
static inline void box_placement(box_text *text, int id, const double point[3],
                                 const double z[3], const double x[3])
{
    box_add(text, "#%d=AXIS2_PLACEMENT_3D('',#%d,#%d,#%d);\n", id, id + 1, id + 2, id + 3);
    box_add(text, "#%d=CARTESIAN_POINT('',(%.17g,%.17g,%.17g));\n", id + 1, point[0], point[1],
            point[2]);
    box_add(text, "#%d=DIRECTION('',(%.17g,%.17g,%.17g));\n", id + 2, z[0], z[1], z[2]);
    box_add(text, "#%d=DIRECTION('',(%.17g,%.17g,%.17g));\n", id + 3, x[0], x[1], x[2]);
}

/* Corners 0 .. 7 by the bits x, y, z; the edges and, for each face, corners counter-clockwise
 * from outside. */
static const int BOX_SIDES[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                    {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

/* The edge between two corners: its number, and whether it runs from a to b. */
static inline int box_edge(int a, int b, bool *forward)
{
    const int low = a < b ? a : b, axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2;
    static const int at[3][8] = {{0, 0, 1, 1, 2, 2, 3, 3}, /* by what is left of the corner */
                                 {0, 1, 0, 1, 2, 3, 2, 3},
                                 {0, 1, 2, 3, 0, 1, 2, 3}};
    *forward = a < b;
    return 4 * axis + at[axis][low];
}

static inline const char *box_flag(bool value)
{
    return value ? ".T." : ".F.";
}

static inline void box_edges(box_text *text, int id, const double origin[3], double size,
                             unsigned turns)
{
    for (int c = 0; c < 8; c++) {
        box_add(text, "#%d=CARTESIAN_POINT('',(%.17g,%.17g,%.17g));\n", id + c,
                origin[0] + (c & 1 ? size : 0), origin[1] + (c & 2 ? size : 0),
                origin[2] + (c & 4 ? size : 0));
        box_add(text, "#%d=VERTEX_POINT('',#%d);\n", id + 8 + c, id + c);
    }
    for (int a = 0; a < 8; a++)
        for (int axis = 0; axis < 3; axis++) {
            const int b = a | 1 << axis;
            bool forward = true;
            if (a == b)
                continue;
            const int e = box_edge(a, b, &forward);
            const int from = turns & BOX_EDGES ? b : a, to = turns & BOX_EDGES ? a : b;
            const double sign = !(turns & BOX_EDGES) == !(turns & BOX_LINES) ? 1 : -1;
            box_add(text, "#%d=DIRECTION('',(%g,%g,%g));\n", id + 20 + e, axis == 0 ? sign : 0,
                    axis == 1 ? sign : 0, axis == 2 ? sign : 0);
            box_add(text, "#%d=VECTOR('',#%d,2.);\n", id + 40 + e, id + 20 + e);
            box_add(text, "#%d=LINE('',#%d,#%d);\n", id + 60 + e, id + a, id + 40 + e);
            box_add(text, "#%d=EDGE_CURVE('',#%d,#%d,#%d,%s);\n", id + 80 + e, id + 8 + from,
                    id + 8 + to, id + 60 + e, box_flag(!(turns & BOX_LINES)));
        }
}

static inline void box_loop(box_text *text, int id, int face, bool against, unsigned turns)
{
    for (int k = 0; k < 4; k++) {
        const int *corners = BOX_SIDES[face];
        const int a = corners[against ? (4 - k) % 4 : k],
                  b = corners[against ? 3 - k : (k + 1) % 4];
        bool forward = true;
        const int e = box_edge(a, b, &forward);
        box_add(text, "#%d=ORIENTED_EDGE('',*,*,#%d,%s);\n", id + 100 + 4 * face + k,
                id + 80 + e, box_flag(forward == !(turns & BOX_EDGES)));
    }
    box_add(text, "#%d=EDGE_LOOP('',(#%d,#%d,#%d,#%d));\n", id + 130 + face,
            id + 100 + 4 * face, id + 101 + 4 * face, id + 102 + 4 * face, id + 103 + 4 * face);
}

/* A box with its corner at the origin: #id + 180 is its CLOSED_SHELL, or what wraps it; faces
 * are #id + 150 .. + 155. Ids up to #id + 199 are taken. */
static inline void box_shell(box_text *text, int id, const double origin[3], double size,
                             unsigned turns)
{
    const bool inwards = !(turns & BOX_SHELL) != !(turns & BOX_FACES);
    box_edges(text, id, origin, size, turns);
    for (int f = 0; f < 6; f++) {
        double normal[3] = {0, 0, 0}, x[3] = {0, 0, 0};
        const int axis = f < 2 ? 2 : f < 4 ? 1 : 0;
        const bool plane_in = turns & BOX_PLANES, bound_back = turns & BOX_BOUNDS;
        normal[axis] = (f % 2 ? 1 : -1) * (plane_in ? -1 : 1);
        x[(axis + 1) % 3] = 1;
        double at[3];
        memcpy(at, origin, sizeof at);
        at[axis] += f % 2 ? size : 0;
        box_loop(text, id, f, inwards != bound_back, turns);
        box_add(text, "#%d=FACE_OUTER_BOUND('',#%d,%s);\n", id + 140 + f, id + 130 + f,
                box_flag(!bound_back));
        box_placement(text, id + 200 + 4 * f, at, normal, x);
        box_add(text, "#%d=PLANE('',#%d);\n", id + 230 + f, id + 200 + 4 * f);
        box_add(text, "#%d=ADVANCED_FACE('side %d',(#%d),#%d,%s);\n", id + 150 + f, f,
                id + 140 + f, id + 230 + f, box_flag(plane_in == inwards));
        box_add(text, "#%d=ORIENTED_FACE('',*,#%d,.F.);\n", id + 160 + f, id + 150 + f);
    }
    const int first = turns & BOX_FACES ? id + 160 : id + 150;
    box_add(text, "#%d=CLOSED_SHELL('',(#%d,#%d,#%d,#%d,#%d,#%d));\n",
            turns & BOX_SHELL ? id + 181 : id + 180, first, first + 1, first + 2, first + 3,
            first + 4, first + 5);
    if (turns & BOX_SHELL)
        box_add(text, "#%d=ORIENTED_CLOSED_SHELL('',*,#%d,.F.);\n", id + 180, id + 181);
}

/* Traced and measured. */
static inline batten_body_measures box_measure(const batten_body *body)
{
    batten_body_measures measures;
    batten_body_trace_report report;
    batten_body *traced = NULL;
    CHECK_OK(batten_body_trace(body, 1e-6, NULL, NULL, &report, &traced));
    CHECK_INT(report.failed, 0);
    CHECK_OK(batten_body_measure(traced, 1e-9, NULL, &measures));
    batten_body_unref(traced);
    return measures;
}

#endif
