/* Analytic surfaces: what the standard does not have, and is understood. */
#include "exchange/iges/text.h"
#include "exchange/reading.h"

static const struct {
    const char *torus;
    double outermost; /* 0: refused */
} tori[] = {{"198,1,3,5.,2.;", 7},
            {"198,1,3,-5.,2.;", 7},
            {"198,1,3,0.,2.;", 0},
            {"198,1,3,5.,-2.;", 0}};

TEST(a_torus_of_negative_major_radius_is_read_with_a_note)
{
    for (int k = 0; k < COUNT(tori); k++) {
        iges_text file = iges_begin();
        iges_add(&file, 116, 0, 0, 0, "00010000", "116,0.,0.,0.;");
        iges_add(&file, 123, 0, 0, 0, "00010200", "123,0.,0.,1.;");
        iges_add(&file, 198, 0, 0, 0, "00010000", tori[k].torus);
        iges_add(&file, 100, 0, 0, 0, "00010000", "100,0.,0.,0.,7.,0.,7.,0.;");
        iges_add(&file, 100, 0, 0, 0, "00010000", "100,2.,0.,0.,5.,0.,5.,0.;");
        iges_add(&file, 141, 0, 0, 0, "00010000", "141,0,0,5,1,7,1,0;");
        iges_add(&file, 141, 0, 0, 0, "00010000", "141,0,0,5,1,9,1,0;");
        iges_add(&file, 143, 0, 0, 0, "00000000", "143,0,5,2,11,13;");
        const char *text = iges_end(&file, IGES_GLOBAL);
        if (tori[k].outermost == 0) {
            check_refused(text, BATTEN_FORMAT_AUTO, BATTEN_UNSUPPORTED,
                          "its 1 entity could not be read");
            continue;
        }
        batten_model *model =
            read_noting(text, BATTEN_FORMAT_AUTO, k == 1 ? "its major radius is -5" : "");
        CHECK_INT(batten_model_count(model), 1);
        CHECK_NEAR(batten_body_box(batten_model_object(model, 0)->body).high.x,
                   tori[k].outermost, 1e-12);
        batten_model_unref(model);
    }
}
