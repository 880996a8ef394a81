/* 102: members joined within the tolerance of their size. */
#include "exchange/iges/faces.h"

static const char part[] = "00010000", root[] = "00000000";

/* Members one after another along x, the second after a gap; the resolution is 1e-6. */
static iges_text with_gap(int count, double gap)
{
    iges_text file = iges_begin();
    char text[100], composite[100];
    snprintf(composite, sizeof composite, "102,%d", count);
    for (int i = 0; i < count; i++) {
        snprintf(text, sizeof text, "110,%.17g,0.,0.,%d.,0.,0.;", i + (i == 1) * gap, i + 1);
        snprintf(composite + strlen(composite), 20, ",%d",
                 iges_add(&file, 110, 0, 0, 0, part, text));
    }
    iges_add(&file, 102, 0, 0, 0, root, strcat(composite, ";"));
    return file;
}

TEST(any_number_of_members_is_joined_within_the_resolution)
{
    static const double gaps[] = {0, 5e-7};
    for (int count = 1; count <= 7; count++)
        for (int k = 0; k < COUNT(gaps); k++) {
            iges_text file = with_gap(count, gaps[k]);
            batten_model *model =
                read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
            CHECK_INT(batten_model_count(model), 1);
            const batten_curve *curve = batten_model_object(model, 0)->curve;
            CHECK_INT(batten_curve_point_count(curve), count + 1);
            for (int i = 0; i <= count; i++)
                CHECK_NEAR(batten_curve_points(curve)[3 * i], i, gaps[k]);
            batten_model_unref(model);
        }
    iges_text file = with_gap(3, 1e-3);
    iges_add(&file, 116, 0, 0, 0, root, "116,1.,2.,3.;");
    iges_check_partly(&file, "0.001");
}

TEST(points_among_members_say_nothing_of_the_shape)
{
    static const struct {
        const char *composite, *words;
    } cases[] = {{"102,4,3,5,3,7;", ""},
                 {"102,2,3,3;", "none of its members is a curve; left out"},
                 {"102,0;", "it has 0 members; left out"},
                 {"102,2,5,2;", "2 is not the odd number of an entity; left out"},
                 {"102,2,5,99;", "it refers to entity D99, which is missing; left out"}};
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 116, 0, 0, 0, root, "116,1.,2.,3.;");
        iges_add(&file, 116, 0, 0, 0, part, "116,1.,2.,3.;");
        iges_add(&file, 110, 0, 0, 0, part, "110,0.,0.,0.,1.,0.,0.;");
        iges_add(&file, 110, 0, 0, 0, part, "110,1.,0.,0.,1.,1.,0.;");
        iges_add(&file, 102, 0, 0, 0, root, cases[i].composite);
        if (cases[i].words[0]) {
            iges_check_partly(&file, cases[i].words);
            continue;
        }
        batten_model *model = NULL;
        CHECK_OK(read_text(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, NULL, &model));
        CHECK_INT(batten_curve_point_count(batten_model_object(model, 1)->curve), 3);
        batten_model_unref(model);
    }
}
