#include "exchange/iges/iges.h"

#include "exchange/iges/text.h"

static const char *with_global(const char *global)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    return iges_end(&file, global);
}

TEST(the_unit_is_that_of_the_flag_or_of_the_name)
{
    const struct {
        const char *unit, *note;
        double metres;
    } cases[] = {
        {"2,2HMM", "", 0.001},
        {"6,1HM", "", 1},
        {"1,4HINCH", "", 0.0254},
        {"4,2HFT", "", 0.3048},
        {"11,3HUIN", "", 2.54e-8},
        {"10,", "", 0.01},
        {"3,2HCM", "", 0.01},
        {"3,3Hmil", "", 0.0000254},
        {"2,1HM", "the flag is used", 0.001},
        {",2HMM", "", 0.001},
        {",", "gives no unit; inches are assumed", 0.0254},
        {"3,4HEL L", "has the flag 3 and the name 'EL L', which", 0.0254},
        {"3,20Haaaaaaaaaaaaaaaaaaaa", "the name 'aaaaaaaaaaaaaaaaaaaa'", 0.0254},
        {"77,2HMM", "has the flag 77 and the name 'MM', which", 0.0254},
        {"77,", "has the flag 77, which IGES does not have", 0.0254},
        {",3HFOO", "has the name 'FOO', which", 0.0254},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char global[200];
        snprintf(global, sizeof global, ",,1Hx,1Hx,1Hx,1Hx,32,38,6,308,15,1Hx,1.,%s;",
                 cases[i].unit);
        batten_model *model =
            read_noting(with_global(global), BATTEN_FORMAT_AUTO, cases[i].note);
        CHECK_BITS(batten_model_unit_metres(model), cases[i].metres);
        batten_model_unref(model);
    }
    check_refused(with_global(",,1Hx,1Hx,1Hx,1Hx,32,38,6,308,15,1Hx,1.,mm,2HMM;"),
                  BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT, "global section, unit");
    batten_model_unref(
        read_noting(with_global(",,1Hx,1Hx,1Hx,1Hx,32,38,6,308,15,1Hx,0.5,6,1HM;"),
                    BATTEN_FORMAT_AUTO, "drawn at scale 0.5"));
}

TEST(every_unit_of_IGES_has_a_flag)
{
    static const double metres[] = {0, 0.0254, 0.001,   0,    0.3048, 1609.344,
                                    1, 1000,   2.54e-5, 1e-6, 0.01,   2.54e-8};
    for (int flag = 1; flag <= 11; flag++) {
        char global[200];
        if (flag == 3)
            continue;
        CHECK_INT(bat_iges_flag_of_unit(metres[flag]), flag);
        snprintf(global, sizeof global, ",,1Hx,1Hx,1Hx,1Hx,32,38,6,308,15,1Hx,1.,%d,;", flag);
        batten_model *model = NULL;
        CHECK_OK(read_text(with_global(global), BATTEN_FORMAT_AUTO, NULL, &model));
        CHECK_BITS(batten_model_unit_metres(model), metres[flag]);
        batten_model_unref(model);
    }
    CHECK_INT(bat_iges_flag_of_unit(2.5), 3);
}

TEST(F7_other_forms_of_IGES_are_refused_by_name)
{
    char text[82];
    snprintf(text, sizeof text, "%72sC      1\n", "");
    check_refused(text, BATTEN_FORMAT_AUTO, BATTEN_UNSUPPORTED, "compressed form");
    snprintf(text, sizeof text, "%72sB      1\n", "");
    check_refused(text, BATTEN_FORMAT_AUTO, BATTEN_UNSUPPORTED, "binary form");
    check_refused("1 2\n", BATTEN_FORMAT_IGES, BATTEN_BAD_FORMAT, "not an IGES file");
    check_refused("", BATTEN_FORMAT_IGES, BATTEN_BAD_FORMAT, "the file is empty");
}

TEST(F2_a_file_cut_at_any_byte_is_refused_or_partly_read)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    iges_add(&file, 128, 0, 0, 0, "00000000", IGES_SURFACE);
    const char *text = iges_end(&file, IGES_GLOBAL);
    const size_t size = strlen(text);
    /* After the letter T in column 73 of the last record nothing is missing but blanks. */
    const size_t step = test_cases(1000) < 1000 ? 97 : 1;
    for (size_t cut = 0; cut <= size - 81 + 72; cut += step) {
        batten_model *model = NULL;
        CHECK(read_bytes(text, cut, BATTEN_FORMAT_IGES, NULL, &model) != BATTEN_OK);
        batten_model_unref(model);
    }
}

TEST(hulls_written_by_others_are_read)
{
    const struct {
        const char *path, *name;
        int count;
        double unit;
    } files[] = {
        {"hull_surfaces/cargo_hull_sections.igs", "Station 155.000 m", 31, 1},
        {"hull_surfaces/cargo_hull_surface.igs", "Hull", 1, 1},
        {"hull_surfaces/cargo_hull_deck_edge.igs", "3d BsCrv", 1, 1},
        {"hull_surfaces/ropax_maxsurf.igs", "urface 1 1", 4, 1},
        {"iges/geomagic_lens.igs", "surface D1", 9, 0.0254},
        {"iges/rhino_sphere.igs", "TrimSrf", 1, 0.001},
    };
    for (int i = 0; i < COUNT(files); i++) {
        batten_model *model = NULL;
        CHECK_OK(batten_read_file(test_data(files[i].path), NULL, NULL, NULL, &model));
        CHECK_INT(batten_model_count(model), files[i].count);
        CHECK_TEXT(batten_model_object(model, 0)->name, files[i].name);
        CHECK_BITS(batten_model_unit_metres(model), files[i].unit);
        batten_model_unref(model);
    }
}

TEST(the_sphere_of_another_program_is_round)
{
    batten_model *model = NULL;
    batten_box box;
    CHECK_OK(batten_read_file(test_data("iges/rhino_sphere.igs"), NULL, NULL, NULL, &model));
    const batten_surface *sphere = batten_model_object(model, 0)->surface;
    CHECK(batten_model_box(model, &box));
    const double radius = (box.high.z - box.low.z) / 2, centre = (box.high.z + box.low.z) / 2;
    const batten_interval u = batten_surface_domain(sphere, BATTEN_U);
    const batten_interval v = batten_surface_domain(sphere, BATTEN_V);
    for (int i = 0; i <= 20; i++)
        for (int j = 0; j <= 20; j++) {
            double p[3];
            CHECK_OK(batten_surface_evaluate(sphere, u.a + (u.b - u.a) * i / 20,
                                             v.a + (v.b - v.a) * j / 20, 0, p));
            const double x = p[0] - (box.high.x + box.low.x) / 2;
            const double y = p[1] - (box.high.y + box.low.y) / 2;
            CHECK_NEAR(hypot(hypot(x, y), p[2] - centre), radius, 1e-9 * radius);
        }
    batten_model_unref(model);
}

TEST(F2_mutated_files_are_read_or_refused_and_nothing_worse)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 7, -9, "00000000", "110,1.,2.,3.,4.,5.,6.,0,1,5;");
    iges_add(&file, 128, 0, 7, 0, "00000000", IGES_SURFACE);
    iges_add(&file, 406, 15, 0, 0, "00010300", "406,1,4Hkeel;");
    iges_add(&file, 124, 0, 0, 0, "00000000", "124,0.,-1.,0.,0.,1.,0.,0.,0.,0.,0.,1.,0.;");
    iges_add(&file, 314, 0, 0, 0, "00000200", "314,25.,50.,100.;");
    const char *text = iges_end(&file, IGES_GLOBAL);
    const size_t size = strlen(text);
    char *bent = test_array(size + 1, 1);
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(2000); i++) {
        memcpy(bent, text, size);
        for (int k = test_random_int(&random, 1, 4); k > 0; k--) {
            static const char bytes[] = "0123456789+-.,;HDE \t\n\r\xff";
            bent[test_random_int(&random, 0, (int)size - 1)] =
                bytes[test_random_int(&random, 0, sizeof bytes - 2)];
        }
        batten_model *model = NULL;
        read_bytes(bent, size, BATTEN_FORMAT_IGES, NULL, &model);
        batten_model_unref(model);
    }
}
