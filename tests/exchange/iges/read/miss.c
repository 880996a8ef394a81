/* How far edges miss their surfaces: each elementary one by its formula. */
#include "exchange/iges/faces.h"

static const char part[] = "00010000", root[] = "00000000";

/* Circles about the axis whose radius or height is 1e-4 off, with the distance that this makes. */
static const struct {
    int type;
    const char *surface, *circles[2];
    double miss;
} cases[] = {
    {190, "190,1,3;", {"100,2.0001,0.,0.,1.,0.,1.,0.;"}, 1e-4},
    {192,
     "192,1,3,1.;",
     {"100,2.,0.,0.,1.0001,0.,1.0001,0.;", "100,5.,0.,0.,1.,0.,1.,0.;"},
     1e-4},
    /* A cone of 30 degrees: the distance is the cosine of its half angle times that. */
    {194,
     "194,1,3,1.,30.;",
     {"100,2.,0.,0.,1.0001,0.,1.0001,0.;",
      "100,5.,0.,0.,2.732050807568877,0.,2.732050807568877,0.;"},
     0.8660254037844387e-4},
    {196, "196,1,3.,3;", {"100,2.,0.,0.,3.0001,0.,3.0001,0.;"}, 1e-4},
    {198,
     "198,1,3,5.,2.;",
     {"100,2.,0.,0.,7.0001,0.,7.0001,0.;", "100,2.,0.,0.,3.,0.,3.,0.;"},
     1e-4},
};

TEST(what_edges_miss_their_surface_by_is_measured_by_its_formula)
{
    for (int i = 0; i < COUNT(cases); i++) {
        char loops[] = "143,0,5,1,9,13;", words[200];
        iges_text file = iges_begin();
        iges_add(&file, 116, 0, 0, 0, part, "116,0.,0.,2.;");            /* 1 */
        iges_add(&file, 123, 0, 0, 0, part, "123,0.,0.,1.;");            /* 3 */
        iges_add(&file, cases[i].type, 0, 0, 0, part, cases[i].surface); /* 5 */
        for (int k = 0; k < 2 && cases[i].circles[k]; k++) {
            iges_add(&file, 100, 0, 0, 0, part, cases[i].circles[k]); /* 7, 11 */
            iges_add(&file, 141, 0, 0, 0, part,
                     k ? "141,0,0,5,1,11,1,0;" : "141,0,0,5,1,7,1,0;");
        }
        loops[8] = cases[i].circles[1] ? '2' : '1';
        if (!cases[i].circles[1])
            strcpy(loops + 11, ";");
        iges_add(&file, 143, 0, 0, 0, root, loops);
        snprintf(
            words, sizeof words,
            "bodies whose edges miss their surfaces by %g at most, more than the resolution "
            "of the file, 1e-06: 1; their tolerance is twice that",
            cases[i].miss);
        batten_model *model =
            read_so(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, BATTEN_OK, words);
        const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
        CHECK_NEAR(p->tolerance, 2 * cases[i].miss, 1e-12);
        batten_model_unref(model);
    }
}
