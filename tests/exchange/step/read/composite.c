/* Composite curves: any number of segments, either way round, and the gaps between them. */
#include "exchange/step/parsing.h"
#include "exchange/step/read/shapes.h"

static const bat_step_scale millimetres = {1, 1, 1e-6};

/* Segments along x, the bits of `turned` written from their end, the second after a gap. */
static const char *row(int count, unsigned turned, double gap)
{
    char *text = test_array(4000, 1), *at = text;
    for (int i = 0; i < count; i++) {
        const bool against = turned >> i & 1;
        const double from = i + (i == 1) * gap, to = i + 1;
        at += sprintf(at, "#%d=CARTESIAN_POINT('',(%.17g,0.,0.));\n", 10 * i + 1,
                      against ? to : from);
        at += sprintf(at, "#%d=CARTESIAN_POINT('',(%.17g,0.,0.));\n", 10 * i + 2,
                      against ? from : to);
        at += sprintf(at, "#%d=POLYLINE('',(#%d,#%d));\n", 10 * i + 3, 10 * i + 1, 10 * i + 2);
        at += sprintf(at, "#%d=%sCOMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,%s,#%d%s);\n", 10 * i + 4,
                      i % 3 == 2 ? "REPARAMETRISED_" : "", against ? ".F." : ".T.", 10 * i + 3,
                      i % 3 == 2 ? ",1." : "");
    }
    at += sprintf(at, "#100=COMPOSITE_CURVE('',(");
    for (int i = 0; i < count; i++)
        at += sprintf(at, "%s#%d", i ? "," : "", 10 * i + 4);
    sprintf(at, "),.U.);\n");
    return step_whole(text);
}

TEST(segments_of_any_number_are_joined_in_their_order)
{
    for (int count = 1; count <= 7; count++)
        for (unsigned turned = 0; turned < 1u << count; turned += 1 + turned / 4) {
            step_text_file t = {.notes = NULL};
            batten_curve *curve = NULL;
            CHECK_OK(step_begin(&t, row(count, turned, 0)));
            CHECK_OK(bat_step_read_curve(&t.file, step_find(&t, 100), &millimetres, &curve));
            CHECK_INT(batten_curve_point_count(curve), count + 1);
            for (int i = 0; i <= count; i++)
                CHECK_BITS(batten_curve_points(curve)[3 * i], i);
            CHECK_INT(t.input.left_out, 0);
            step_check_note(&t, "");
            batten_curve_unref(curve);
            step_end(&t);
        }
}

/* A gap up to the tolerance says nothing, up to a hundred times that it is noted, beyond refused. */
TEST(gaps_between_segments_are_closed_up_to_a_hundred_times_the_tolerance)
{
    static const struct {
        double gap;
        const char *note;
        batten_status status;
    } cases[] = {
        {0.999e-6, "", BATTEN_OK},
        {1.001e-6, "#100: two of its segments are farther than 1e-06 apart; joined", BATTEN_OK},
        {0.999e-4, "#100: two of its segments are farther than 1e-06 apart; joined", BATTEN_OK},
        {1.001e-4, NULL, BATTEN_NOT_COMPATIBLE}};
    for (int i = 0; i < COUNT(cases); i++) {
        step_text_file t = {.notes = NULL};
        batten_curve *curve = NULL;
        CHECK_OK(step_begin(&t, row(3, 0, cases[i].gap)));
        CHECK_STATUS(bat_step_read_curve(&t.file, step_find(&t, 100), &millimetres, &curve),
                     cases[i].status);
        CHECK((curve != NULL) == (cases[i].status == BATTEN_OK));
        if (cases[i].note)
            step_check_note(&t, cases[i].note);
        else
            CHECK_MESSAGE("#100 COMPOSITE_CURVE: ");
        if (batten_notes_count(t.notes) > 0)
            CHECK_INT(batten_notes_at(t.notes, 0)->line, 20);
        batten_curve_unref(curve);
        step_end(&t);
    }
}
