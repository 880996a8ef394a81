/* The types of entities: how they are called, what they become, who reads them. */
#include "exchange/iges/read/bodies.h"
#include "exchange/iges/read/curves.h"
#include "exchange/iges/read/instances.h"
#include "exchange/iges/read/surfaces.h"

#include <stdio.h>

#define ANY (-1000000), 1000000
#define UNREAD BAT_IGES_UNKNOWN, ANY, NULL, NULL

static const bat_iges_row rows[] = {
    {0, "0 nothing", BAT_IGES_AUXILIARY, ANY, NULL, NULL},
    {100, "100 arc", BAT_IGES_CURVE, 0, 0, bat_iges_read_arc, NULL},
    {102, "102 composite curve", BAT_IGES_CURVE, 0, 0, bat_iges_read_composite, "n(p)"},
    {104, "104 conic", BAT_IGES_CURVE, 0, 3, bat_iges_read_conic, NULL},
    {106, "106 copious data", BAT_IGES_CURVE, 1, 63, bat_iges_read_copious, NULL},
    {108, "108 plane", BAT_IGES_SURFACE, 0, 1, bat_iges_read_plane, "....p"},
    {110, "110 line", BAT_IGES_CURVE, 0, 0, bat_iges_read_line, NULL},
    {112, "112 spline curve", BAT_IGES_CURVE, 0, 0, bat_iges_read_spline_curve, NULL},
    {114, "114 spline surface", BAT_IGES_SURFACE, 0, 0, bat_iges_read_spline_surface, NULL},
    {116, "116 point", BAT_IGES_POINTS, 0, 0, bat_iges_read_point, NULL},
    {118, "118 ruled surface", BAT_IGES_SURFACE, 0, 1, bat_iges_read_ruled, "pp"},
    {120, "120 surface of revolution", BAT_IGES_SURFACE, 0, 0, bat_iges_read_revolution, "pp"},
    {122, "122 tabulated cylinder", BAT_IGES_SURFACE, 0, 0, bat_iges_read_tabulated, "p"},
    {123, "123 direction", BAT_IGES_AUXILIARY, 0, 0, NULL, NULL},
    {124, "124 matrix", BAT_IGES_AUXILIARY, ANY, NULL, NULL},
    {125, "125 flash", UNREAD},
    {126, "126 B-spline curve", BAT_IGES_CURVE, 0, 5, bat_iges_read_nurbs_curve, NULL},
    {128, "128 B-spline surface", BAT_IGES_SURFACE, 0, 9, bat_iges_read_nurbs_surface, NULL},
    {130, "130 offset curve", BAT_IGES_CURVE, 0, 0, bat_iges_read_offset_curve, "p.p"},
    {132, "132 connect point", UNREAD},
    {134, "134 node", UNREAD},
    {136, "136 finite element", UNREAD},
    {140, "140 offset surface", BAT_IGES_SURFACE, 0, 0, bat_iges_read_offset_surface, "....p"},
    {141, "141 boundary", BAT_IGES_PART, 0, 0, NULL, "..pn(p.n(p))"},
    {142, "142 curve on a surface", BAT_IGES_PART, 0, 0, NULL, ".ppp"},
    {143, "143 bounded surface", BAT_IGES_BODY, 0, 0, bat_iges_read_bounded, ".pn(p)"},
    {144, "144 trimmed surface", BAT_IGES_BODY, 0, 0, bat_iges_read_trimmed, "p.np(p)"},
    {150, "150 block", UNREAD},
    {152, "152 wedge", UNREAD},
    {154, "154 cylinder", UNREAD},
    {156, "156 cone", UNREAD},
    {158, "158 sphere", UNREAD},
    {160, "160 torus", UNREAD},
    {162, "162 solid of revolution", UNREAD},
    {164, "164 solid of extrusion", UNREAD},
    {168, "168 ellipsoid", UNREAD},
    {180, "180 Boolean tree", UNREAD},
    {184, "184 assembly of solids", UNREAD},
    {186, "186 solid", BAT_IGES_BODY, 0, 0, bat_iges_read_solid, "p.n(p.)"},
    {190, "190 plane surface", BAT_IGES_SURFACE, 0, 1, bat_iges_read_unbounded, "ppp"},
    {192, "192 cylindrical surface", BAT_IGES_SURFACE, 0, 1, bat_iges_read_unbounded, "pp.p"},
    {194, "194 conical surface", BAT_IGES_SURFACE, 0, 1, bat_iges_read_unbounded, "pp..p"},
    {196, "196 spherical surface", BAT_IGES_SURFACE, 0, 1, bat_iges_read_unbounded, "p.pp"},
    {198, "198 toroidal surface", BAT_IGES_SURFACE, 0, 1, bat_iges_read_unbounded, "pp..p"},
    {202, "202 angular dimension", UNREAD},
    {206, "206 diameter dimension", UNREAD},
    {210, "210 label", UNREAD},
    {212, "212 note", UNREAD},
    {214, "214 leader", UNREAD},
    {216, "216 linear dimension", UNREAD},
    {218, "218 ordinate dimension", UNREAD},
    {220, "220 point dimension", UNREAD},
    {222, "222 radius dimension", UNREAD},
    {228, "228 symbol", UNREAD},
    {230, "230 hatched area", UNREAD},
    {302, "302 definition of an associativity", BAT_IGES_AUXILIARY, ANY, NULL, NULL},
    {304, "304 line font", BAT_IGES_AUXILIARY, ANY, NULL, NULL},
    {308, "308 subfigure", BAT_IGES_PART, 0, 0, bat_iges_read_definition, "..n(p)"},
    {310, "310 text font", BAT_IGES_AUXILIARY, ANY, NULL, NULL},
    {312, "312 text template", BAT_IGES_AUXILIARY, ANY, NULL, NULL},
    {314, "314 colour", BAT_IGES_AUXILIARY, ANY, NULL, NULL},
    {316, "316 units", BAT_IGES_AUXILIARY, ANY, NULL, NULL},
    {322, "322 attribute table", BAT_IGES_AUXILIARY, ANY, NULL, NULL},
    {402, "402 group", BAT_IGES_AUXILIARY, ANY, NULL, NULL},
    {404, "404 drawing", BAT_IGES_AUXILIARY, ANY, NULL, NULL},
    {406, "406 property", BAT_IGES_AUXILIARY, ANY, NULL, NULL},
    {408, "408 instance of a subfigure", BAT_IGES_INSTANCE, 0, 0, bat_iges_read_instance, "p"},
    {410, "410 view", BAT_IGES_AUXILIARY, ANY, NULL, NULL},
    {422, "422 attributes", BAT_IGES_AUXILIARY, ANY, NULL, NULL},
    {502, "502 vertices", BAT_IGES_PART, 0, 1, NULL, NULL},
    {504, "504 edges", BAT_IGES_PART, 0, 1, NULL, "n(pp.p.)"},
    {508, "508 loop", BAT_IGES_PART, 0, 1, NULL, "n(.p..n(.p))"},
    {510, "510 face", BAT_IGES_BODY, 0, 1, bat_iges_read_face, "pn.(p)"},
    {514, "514 shell", BAT_IGES_BODY, 0, 2, bat_iges_read_shell, "n(p.)"},
};

const bat_iges_row *bat_iges_row_of(int type)
{
    static const bat_iges_row unknown = {-1, "entity", BAT_IGES_UNKNOWN, 0, 0, NULL, NULL};
    size_t low = 0, high = sizeof rows / sizeof rows[0];
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (rows[middle].type == type)
            return &rows[middle];
        if (rows[middle].type < type)
            low = middle + 1;
        else
            high = middle;
    }
    return &unknown;
}

void bat_iges_name_of_type(int type, char name[BAT_IGES_TYPE_NAME])
{
    const bat_iges_row *row = bat_iges_row_of(type);
    if (row->type == type)
        snprintf(name, BAT_IGES_TYPE_NAME, "%s", row->name);
    else
        snprintf(name, BAT_IGES_TYPE_NAME, "%d, a type that is not known", type);
}
