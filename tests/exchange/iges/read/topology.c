/* Lists of vertices and edges: curves that run either way, go farther or miss their vertices. */
#include "exchange/iges/faces.h"

static const char part[] = "00010000", root[] = "00000000";

/* A triangle of which the first edge, from (1, 1) to (3, 1), has this curve. */
static iges_text with_edge(const char *curve)
{
    iges_text file = iges_begin();
    iges_add(&file, 108, 0, 0, 0, part, "108,0.,0.,1.,0.,0;");                      /* 1 */
    iges_add(&file, 502, 1, 0, 0, part, "502,2,1.,1.,0.,3.,1.,0.;");                /* 3 */
    iges_add(&file, 502, 1, 0, 0, part, "502,1,1.,2.,0.;");                         /* 5 */
    iges_add(&file, 110, 0, 0, 0, part, curve);                                     /* 7 */
    iges_add(&file, 110, 0, 0, 0, part, "110,3.,1.,0.,1.,2.,0.;");                  /* 9 */
    iges_add(&file, 110, 0, 0, 0, part, "110,1.,2.,0.,1.,1.,0.;");                  /* 11 */
    iges_add(&file, 504, 1, 0, 0, part, "504,2,7,3,1,3,2,9,3,2,5,1;");              /* 13 */
    iges_add(&file, 504, 1, 0, 0, part, "504,1,11,5,1,3,1;");                       /* 15 */
    iges_add(&file, 508, 1, 0, 0, part, "508,3,0,13,1,1,0,0,13,2,1,0,0,15,1,1,0;"); /* 17 */
    iges_add(&file, 510, 1, 0, 0, root, "510,1,1,1,17;");                           /* 19 */
    return file;
}

static const struct {
    const char *curve, *note;
    double tolerance; /* of what the edge misses its vertices by */
} edges[] = {
    {"110,1.,1.,0.,3.,1.,0.;", "", 1e-15},
    {"110,3.,1.,0.,1.,1.,0.;", "", 1e-15},
    {"110,0.,1.,0.,3.,1.,0.;", "", 1e-9},
    {"110,1.,1.,0.,5.,1.,0.;", "", 1e-9},
    {"110,0.,1.,0.,5.,1.,0.;", "", 1e-9},
    {"110,5.,1.,0.,0.,1.,0.;", "", 1e-9},
    {"110,1.,1.001,0.,3.,1.001,0.;",
     "edges of faces that start away from the end of the one before, by 0.001 at most: 1; put "
     "together halfway",
     1.0011e-3},
};

TEST(an_edge_is_the_part_of_its_curve_from_vertex_to_vertex)
{
    for (int i = 0; i < COUNT(edges); i++) {
        iges_text file = with_edge(edges[i].curve);
        batten_model *model = iges_body(&file, edges[i].note);
        const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
        const batten_body_edge *edge = &p->edges[0];
        const batten_interval domain = batten_curve_domain(edge->curve);
        CHECK_INT(p->vertex_count, 3);
        CHECK_INT(p->edge_count, 3);
        for (int last = 0; last < 2; last++) {
            double end[3];
            const double *v = p->vertices + 3 * (last ? edge->vertices[1] : edge->vertices[0]);
            CHECK_OK(batten_curve_evaluate(edge->curve, last ? domain.b : domain.a, 0, end));
            CHECK_NEAR(v[0], last ? 3 : 1, 0);
            CHECK_NEAR(hypot(end[0] - v[0], end[1] - v[1]), 0, edges[i].tolerance);
        }
        batten_model_unref(model);
    }
}

/* More than a thousandth of its size: it is another curve. */
TEST(an_edge_that_misses_its_vertices_says_by_how_much)
{
    iges_text file = with_edge("110,1.,1.01,0.,3.,1.01,0.;");
    iges_check_left_out(&file, "an edge misses its vertices by 0.01; left out");
}

/* Both faces of a shell use one edge: it is put into the body once, and its lists are read once. */
TEST(edges_that_two_faces_share_are_one)
{
    iges_text file = with_edge("110,1.,1.,0.,3.,1.,0.;");
    memcpy(file.directory + (size_t)(file.entries - 1) * 2 * 81 + 64, part, 8);
    iges_add(&file, 502, 1, 0, 0, part, "502,1,2.,0.,0.;");                         /* 21 */
    iges_add(&file, 110, 0, 0, 0, part, "110,1.,1.,0.,2.,0.,0.;");                  /* 23 */
    iges_add(&file, 110, 0, 0, 0, part, "110,2.,0.,0.,3.,1.,0.;");                  /* 25 */
    iges_add(&file, 504, 1, 0, 0, part, "504,2,23,3,1,21,1,25,21,1,3,2;");          /* 27 */
    iges_add(&file, 508, 1, 0, 0, part, "508,3,0,27,1,1,0,0,27,2,1,0,0,13,1,0,0;"); /* 29 */
    iges_add(&file, 510, 1, 0, 0, part, "510,1,1,1,29;");                           /* 31 */
    iges_add(&file, 514, 2, 0, 0, root, "514,2,19,1,31,1;");
    batten_model *model = iges_body(&file, "");
    const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
    CHECK_INT(p->vertex_count, 4);
    CHECK_INT(p->edge_count, 5);
    CHECK_INT(p->use_count, 6);
    CHECK_INT(p->face_count, 2);
    CHECK(p->uses[5].edge == 0 && p->uses[5].reversed && !p->uses[0].reversed);
    iges_check_area(model, 2);
    batten_model_unref(model);
}
