/* Facets of text whose normals point elsewhere, and words that belong to nothing. */
#include "exchange/meshes/meshes.h"

#define FACET(normal, corners) \
    "facet normal " normal "\nouter loop\n" corners "endloop\nendfacet\n"
#define TO_X "vertex 0 0 0\nvertex 0 1 0\nvertex 0 0 1\n"
#define TO_Y "vertex 0 0 0\nvertex 0 0 1\nvertex 1 0 0\n"
#define TO_Z "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"

/* By the sum over all three coordinates. */
TEST(a_normal_contradicts_its_corners_when_it_points_to_their_other_side)
{
    static const struct {
        const char *facet;
        bool is_against;
    } cases[] = {
        {FACET("1 0 0", TO_X), false},   {FACET("-1 0 0", TO_X), true},
        {FACET("1 -2 -3", TO_X), false}, {FACET("-1 2 3", TO_X), true},
        {FACET("0 1 0", TO_Y), false},   {FACET("0 -1 0", TO_Y), true},
        {FACET("-3 1 -2", TO_Y), false}, {FACET("3 -1 2", TO_Y), true},
        {FACET("0 0 1", TO_Z), false},   {FACET("0 0 -1", TO_Z), true},
        {FACET("-3 -2 1", TO_Z), false}, {FACET("3 2 -1", TO_Z), true},
        {FACET("0 0 0", TO_Z), false},   {FACET("1 0 0", TO_Z), false},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char text[400];
        snprintf(text, sizeof text, "solid s\n%sendsolid s\n", cases[i].facet);
        batten_model_unref(read_noting(
            text, BATTEN_FORMAT_STL,
            cases[i].is_against ? "the normals of 1 of 1 triangles contradict" : ""));
    }
}

/* The message says how many are left out of how many. */
TEST(triangles_outside_of_a_solid_are_counted)
{
    static const char text[] =
        "solid s\n" FACET("0 0 1", TO_Z) "endsolid s\n" FACET("0 0 1", TO_Z)
            FACET("0 0 1", TO_Z);
    batten_model *model = NULL;
    CHECK_STATUS(read_text(text, BATTEN_FORMAT_STL, NULL, &model), BATTEN_PARTLY_READ);
    CHECK_MESSAGE("2 of 3");
    CHECK_INT(mesh_at(model, 0)->triangle_count, 1);
    batten_model_unref(model);
}

static int asked;

static bool count_only(void *user)
{
    (void)user;
    asked++;
    return false;
}

/* Not for every word, which would cost more than the reading. */
TEST(whether_to_go_on_is_asked_now_and_then)
{
    batten_job job = BATTEN_JOB;
    batten_model *model = NULL;
    batten_read_options options = batten_read_defaults();
    enum { FACETS = 25000 };
    const char *facet = FACET("0 0 1", TO_Z);
    char *text = test_array(FACETS * strlen(facet) + 40, 1), *to = text;
    options.format = BATTEN_FORMAT_STL;
    job.is_cancelled = count_only;
    to += sprintf(to, "solid s\n");
    for (int i = 0; i < FACETS; i++)
        to += sprintf(to, "%s", facet);
    sprintf(to, "endsolid s\n");
    asked = 0;
    CHECK_OK(batten_read_memory(text, strlen(text), &options, &job, NULL, &model));
    CHECK(asked >= 2 && asked <= 10);
    batten_model_unref(model);
}
