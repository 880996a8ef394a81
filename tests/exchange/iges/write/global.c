/* The global section and the parameters of entities, to the letter. */
#include "exchange/shapes.h"

#include <batten/text.h>

/* The free columns of all records with that letter, without the blanks at their ends. */
static const char *section(const batten_model *model, const batten_write_options *options,
                           char letter)
{
    char *data = NULL, *text = test_array(1 << 16, 1);
    size_t size = 0;
    batten_write_options chosen = options ? *options : batten_write_defaults();
    chosen.format = BATTEN_FORMAT_IGES;
    CHECK_OK(batten_write_memory(model, &chosen, NULL, &data, &size));
    for (size_t at = 0; at < size; at += 81)
        if (data[at + 72] == letter) {
            size_t width = letter == 'P' ? 64 : 72;
            while (width > 0 && data[at + width - 1] == ' ')
                width--;
            strncat(text, data + at, width);
        }
    batten_release(data);
    return text;
}

static batten_model *one_point(double unit, double x)
{
    const double point[3] = {x, 0, -1};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(unit, &model));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "p",
                                                      .kind = BATTEN_OBJECT_POINTS,
                                                      .point_count = 1,
                                                      .points = point}));
    return model;
}

/* Of the 26 parameters of IGES 5.3: the names, the sizes of numbers, the unit, the date, the
 * resolution, the largest coordinate, version and drafting standard. */
TEST(the_global_section_has_what_the_standard_asks_for)
{
    static const struct {
        const char *date, *written;
        double unit, tolerance;
        const char *said, *resolution;
    } cases[] = {
        {"2026-11-21T10:25:30", "20261121.102530", 1, 0, "6,1HM", "1.E-6"},
        {NULL, "20000101.000000", 0.001, 0, "2,2HMM", "0.001"},
        {"2026-11-21T10:25:3", "20000101.000000", 0.0254, 0.5, "1,2HIN", "0.5"},
        {"2026-11-21T10:25:300", "20000101.000000", 0.3048, 2, "4,2HFT", "2."},
        {"2026-11-21 10:25:30", "20000101.000000", 1000, 1, "7,2HKM", "1."},
        {"2026-1:-21T10:25:30", "20000101.000000", 0.01, 1, "10,2HCM", "1."},
        {"202/-11-21T10:25:30", "20000101.000000", 1e-6, 1, "9,2HUM", "1."},
        {"9999-99-99T99:99:99", "99999999.999999", 0.0000254, 1, "8,3HMIL", "1."},
        {"0000-00-00T00:00:00", "00000000.000000", 1609.344, 1, "5,2HMI", "1."},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char due[400];
        batten_model *model = one_point(cases[i].unit, 7.5);
        batten_write_options options = batten_write_defaults();
        options.date = cases[i].date;
        options.tolerance = cases[i].tolerance;
        options.name = "hull";
        snprintf(
            due, sizeof due,
            "1H,,1H;,4Hhull,4Hhull,6HBatten,%zuH%s,32,38,6,308,17,4Hhull,1.,%s,1,0.,15H%s,%s,"
            "7.5,,,11,0,15H%s;",
            strlen(batten_version()), batten_version(), cases[i].said, cases[i].written,
            cases[i].resolution, cases[i].written);
        CHECK_TEXT(section(model, &options, 'G'), due);
        batten_model_unref(model);
    }
}

/* Level in a plane of equal z, closed, polynomial or with weights; a segment over 0..1 is a line. */
static const struct {
    int degree, count;
    double points[12], knots[8];
    const double *weights;
    const char *written;
} curves[] = {
    {1, 2, {1, 2, 3, 4, 5, 6}, {0, 0, 1, 1}, NULL, "110,1.,2.,3.,4.,5.,6.,0,0;"},
    {1,
     2,
     {1, 2, 3, 4, 5, 6},
     {0, 0, 2, 2},
     NULL,
     "126,1,1,0,0,1,0,0.,0.,2.,2.,1.,1.,1.,2.,3.,4.,5.,6.,0.,2.,0.,0.,0.,0,0;"},
    {1,
     2,
     {1, 2, 3, 4, 5, 6},
     {-0.0, 0, 1, 1},
     NULL,
     "126,1,1,0,0,1,0,-0.,0.,1.,1.,1.,1.,1.,2.,3.,4.,5.,6.,0.,1.,0.,0.,0.,0,0;"},
    {1,
     2,
     {1, 2, 3, 4, 5, 3},
     {1, 1, 2, 2},
     NULL,
     "126,1,1,1,0,1,0,1.,1.,2.,2.,1.,1.,1.,2.,3.,4.,5.,3.,1.,2.,0.,0.,1.,0,0;"},
    {1,
     3,
     {1, 2, 3, 4, 5, 3, 7, 2, 4},
     {0, 0, 1, 2, 2},
     NULL,
     "126,2,1,0,0,1,0,0.,0.,1.,2.,2.,1.,1.,1.,1.,2.,3.,4.,5.,3.,7.,2.,4.,0.,2.,0.,0.,0.,0,0;"},
    {1,
     3,
     {1, 2, 3, 4, 5, 4, 1, 2, 3},
     {0, 0, 1, 2, 2},
     NULL,
     "126,2,1,0,1,1,0,0.,0.,1.,2.,2.,1.,1.,1.,1.,2.,3.,4.,5.,4.,1.,2.,3.,0.,2.,0.,0.,0.,0,0;"},
    {1,
     3,
     {1, 2, 3, 4, 5, 3, 1, 2, 3},
     {0, 0, 1, 2, 2},
     (const double[]){1, 2, 0.5},
     "126,2,1,1,1,0,0,0.,0.,1.,2.,2.,1.,2.,0.5,1.,2.,3.,4.,5.,3.,1.,2.,3.,0.,2.,0.,0.,1.,0,0;"},
};

TEST(curves_are_written_with_their_properties)
{
    for (int i = 0; i < COUNT(curves); i++) {
        batten_model *model = NULL;
        batten_curve *curve = NULL;
        CHECK_OK(batten_model_create(1, &model));
        CHECK_OK(batten_curve_create((batten_points){3, curves[i].count, curves[i].points},
                                     curves[i].degree, curves[i].weights, curves[i].knots,
                                     &curve));
        add_curve(model, "", curve);
        const char *written = section(model, NULL, 'P');
        /* The name comes first, as a property. */
        CHECK_CONTAINS(written, curves[i].written);
        batten_curve_unref(curve);
        batten_model_unref(model);
    }
}
