#include "exchange/reading.h"

static const double expected[][2] = {{1, 0.01}, {0.5, 0.1}, {0, 0}, {0.4, -0.05}, {1, -0.01}};

static void check_points(const char *text, const char *note, const char *name)
{
    batten_model *model = read_noting(text, BATTEN_FORMAT_AEROFOIL, note);
    const batten_object *object = batten_model_object(model, 0);
    CHECK_TEXT(object->name, name);
    CHECK_INT(object->point_count, 5);
    for (int i = 0; i < 5; i++) {
        CHECK_BITS(object->points[3 * i], expected[i][0]);
        CHECK_BITS(object->points[3 * i + 1], expected[i][1]);
        CHECK_BITS(object->points[3 * i + 2], 0.0);
    }
    batten_model_unref(model);
}

TEST(either_order_gives_the_points_from_the_trailing_edge_over_the_upper_side)
{
    check_points(" Selig 12 \n1 .01\n.5 .1\n0 0\n.4 -.05\n1 -.01\n", "", "Selig 12");
    check_points("1, .01\n.5, .1\n0, 0\n.4, -.05\n1, -.01\n", "", "aerofoil");
    check_points("LED, \"x\n3. 3.\n\n0 0\n.5 .1\n1 .01\n\n0 0\n.4 -.05\n1 -.01\n", "",
                 "LED, \"x");
    check_points("no nose twice\n3 2\n0 0\n.5 .1\n1 .01\n.4 -.05\n1 -.01\n", "",
                 "no nose twice");
    check_points("below first\n1 -.01\n.4 -.05\n0 0\n.5 .1\n1 .01\n",
                 "the lower side comes first", "below first");
}

TEST(what_is_no_aerofoil_is_refused)
{
    check_refused("a\n0 0\n.5 .1\n1 0\n", BATTEN_FORMAT_AEROFOIL, BATTEN_BAD_FORMAT,
                  "begin at x = 0 and end at x = 1");
    check_refused("a\n1 0\n0 0\n", BATTEN_FORMAT_AEROFOIL, BATTEN_BAD_FORMAT, "needs at least 3 points");
    check_refused("a\n3 4\n0 0\n.5 .1\n1 .01\n0 0\n.4 -.05\n1 -.01\n", BATTEN_FORMAT_AEROFOIL,
                  BATTEN_BAD_FORMAT, "t:2: 3 and 4 points are announced, but 6 follow");
    check_refused("a\n1 ...\n", BATTEN_FORMAT_AEROFOIL, BATTEN_BAD_FORMAT,
                  "t:2: column 3: '...' is not a number");
    check_refused("1 ...\n1 0\n0 0\nwords and\nwords\n1 0\nwords\n", BATTEN_FORMAT_AEROFOIL,
                  BATTEN_BAD_FORMAT, "t:1: column 3: '...'");
    check_refused("a\n1 0\n1 1\n1 2\n", BATTEN_FORMAT_AEROFOIL, BATTEN_BAD_FORMAT,
                  "not both at the trailing edge");
}

TEST(rows_that_are_no_points_of_an_aerofoil_are_left_out_and_named)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_STATUS(read_text("a\n1 ....\n1 .01\n.5 .1\n0 0\n.5 -.1\n1 -.01\nby the river\n",
                           BATTEN_FORMAT_AUTO, notes, &model),
                 BATTEN_PARTLY_READ);
    CHECK_INT(batten_model_object(model, 0)->point_count, 5);
    if (!batten_notes_dropped(notes)) {
        /* Readings that failed for want of memory noted the same. */
        const int last = batten_notes_count(notes) - 1;
        CHECK_INT(batten_notes_at(notes, 0)->line, 2);
        CHECK_INT(batten_notes_at(notes, last)->line, 8);
        CHECK(has_note(notes, "left out"));
    }
    batten_model_unref(model);
    batten_notes_free(notes);
}

TEST(the_aerofoils_of_the_world_are_read)
{
    const struct {
        const char *file;
        int count;
        const char *name;
        bool is_part; /* a row that is no point is left out */
    } files[] = {
        {"ag35", 180, "AG35", false},
        {"ah93w480b", 112, "AH 93-W-480B", false},
        {"clarky", 121, "CLARK Y AIRFOIL", false},
        {"dae11", 81, "DAE-11 AIRFOIL", false},
        {"e423", 72, "E423", false},
        {"e63", 61, "aerofoil", false},
        {"fx63137", 97, "WORTMANN FX 63-137 AIRFOIL", false},
        {"goe300", 27, "GOE 300 (FRIEDRICHSHAFEN G20) AIRFOIL", false},
        {"goe417a", 31, "GOE 417A (GEW. PLATTE) AIRFOIL", false},
        {"naca0012_pygeo", 160, "aerofoil", false},
        {"naca0012_sharp", 153, "aerofoil", false},
        {"naca23021", 34, "NACA 23021", true},
        {"naca2412_pygeo", 160, "aerofoil", false},
        {"naca643618", 51, "NACA 64(3)-618", false},
        {"raf15", 31, "RAF 15 AIRFOIL", false},
        {"s1223", 300, "S1223HiRes", false},
        {"sc20410", 205, "NASA SC(2)-0410 AIRFOIL", false},
        {"tp29-5", 260, "TP29-5% Profil de stab (c)Th Platon", true},
        {"usa35b", 33, "USA-35B AIRFOIL", false},
        {"whitcomb", 73, "WHITCOMB INTEGRAL SUPERCRITICAL AIRFOIL", false},
    };
    batten_read_options options = batten_read_defaults();
    options.format = BATTEN_FORMAT_AEROFOIL;
    for (int i = 0; i < COUNT(files); i++) {
        char path[64];
        batten_model *model = NULL;
        snprintf(path, sizeof path, "airfoils/%s.dat", files[i].file);
        CHECK_STATUS(batten_read_file(test_data(path), &options, NULL, NULL, &model),
                     files[i].is_part ? BATTEN_PARTLY_READ : BATTEN_OK);
        const batten_object *object = batten_model_object(model, 0);
        CHECK_INT(object->point_count, files[i].count);
        CHECK_TEXT(object->name, files[i].name);
        batten_model_unref(model);
    }
}
