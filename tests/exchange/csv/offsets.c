#include "exchange/reading.h"

static const batten_offset_table *table_of(const batten_model *model)
{
    return batten_model_object(model, 0)->offset_table;
}

/* The points of a station as "y z line" with blanks between. */
static const char *points_of(const batten_offset_table *offsets, int station)
{
    static char text[400];
    const batten_table_station *s = batten_offset_table_station(offsets, station);
    text[0] = '\0';
    for (int k = 0; k < s->point_count; k++)
        snprintf(text + strlen(text), sizeof text - strlen(text), "%s%g,%g,%d", k ? " " : "",
                 s->points[k].y, s->points[k].z, s->points[k].line);
    return text;
}

TEST(each_dialect_gives_the_same_table)
{
    const char *const texts[] = {
        "x_m,z_m,half_breadth_m\n0,0,0\n0,1,2\n3,0,\n3,1,4\n",
        "Height [m];Station [m];Half-breadth [m]\n0;0;0\n1;0;2\n0;3;x\n1;3;4\n",
        "station\\height [m],0,1\n0,0,2\n3,-,4\n",
        "z_m / x_m\t0\t3\n0\t0\t\n1\t2\t4\n",
        "x_m y_m z_m line\n0 0 0 z=0\n0 2 1 z=1\n3 - 0 z=0\n3 4 1 z=1\n",
    };
    for (int i = 0; i < COUNT(texts); i++) {
        batten_model *model = read_noting(texts[i], BATTEN_FORMAT_OFFSET_TABLE, "");
        const batten_offset_table *offsets = table_of(model);
        CHECK_INT(batten_offset_table_station_count(offsets), 2);
        CHECK_TEXT(points_of(offsets, 0), "0,0,0 2,1,1");
        CHECK_TEXT(points_of(offsets, 1), "4,1,1");
        CHECK_TEXT(batten_offset_table_station(offsets, 1)->name, "3");
        CHECK_BITS(batten_offset_table_station(offsets, 1)->x, 3.0);
        CHECK_TEXT(batten_offset_table_line(offsets, 1)->name, "z=1");
        CHECK(batten_offset_table_line(offsets, 1)->is_waterline);
        CHECK_BITS(batten_offset_table_line(offsets, 1)->z, 1.0);
        CHECK_BITS(batten_offset_table_unit_metres(offsets), 1.0);
        CHECK_BITS(batten_model_unit_metres(model), 1.0);
        batten_model_unref(model);
    }
}

TEST(comments_of_a_table_are_counted)
{
    batten_notes *notes = NULL;
    batten_model *model = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(read_text("# LOA 24\nx,z,half_breadth\n0,0,1\n# here\n0,1,2\n", BATTEN_FORMAT_AUTO,
                       notes, &model));
    if (!batten_notes_dropped(notes))
        CHECK(has_note(notes, "2 lines are comments"));
    batten_model_unref(model);
    batten_notes_free(notes);
}

TEST(half_breadths_below_zero_are_kept_and_counted)
{
    batten_model *model = read_noting("x,z,half_breadth\n0,0,1\n0,1,-2\n3,0,-1\n3,1,4\n",
                                      BATTEN_FORMAT_AUTO, "2 half-breadths are below 0");
    CHECK_TEXT(points_of(table_of(model), 0), "1,0,0 -2,1,1");
    batten_model_unref(model);
}

TEST(what_is_no_table_of_offsets_is_refused)
{
    check_refused("1,2,3\n", BATTEN_FORMAT_OFFSET_TABLE, BATTEN_BAD_FORMAT,
                  "no table of offsets");
    check_refused("", BATTEN_FORMAT_OFFSET_TABLE, BATTEN_BAD_FORMAT, "the file is empty");
    check_refused("x,z,y\n", BATTEN_FORMAT_OFFSET_TABLE, BATTEN_BAD_FORMAT,
                  "there is no point");
    check_refused("x,z,y\n1,2,\n", BATTEN_FORMAT_OFFSET_TABLE, BATTEN_BAD_FORMAT,
                  "there is no point");
}

TEST(the_tables_of_real_hulls_are_read)
{
    const struct {
        const char *path;
        int stations, lines;
        double largest, length;
    } files[] = {
        {"hull_offsets/barge_offsets.csv", 2, 2, 5, 22.5},
        {"hull_offsets/gunnerus_offsets.csv", 64, 16, 4.8051, 36.25},
        {"hull_offsets/px121_offsets.csv", 11, 10, 9, 82},
        {"hull_offsets/s60_offsets.csv", 41, 17, 1.696, 25.5},
    };
    for (int i = 0; i < COUNT(files); i++) {
        batten_model *model = NULL;
        batten_box box;
        CHECK_OK(batten_read_file(test_data(files[i].path), NULL, NULL, NULL, &model));
        CHECK_INT(batten_offset_table_station_count(table_of(model)), files[i].stations);
        CHECK_INT(batten_offset_table_line_count(table_of(model)), files[i].lines);
        CHECK(batten_model_box(model, &box));
        CHECK_NEAR(box.high.y, files[i].largest, 1e-3);
        CHECK_NEAR(box.high.x - box.low.x, files[i].length, 1e-3);
        batten_model_unref(model);
    }
}

TEST(F2_a_table_cut_at_any_byte_is_refused_or_noted)
{
    static const char text[] =
        "station,x,z,half_breadth,line\n0,0,0,0,\"keel\"\n0,0.25,1,2,deck\n"
        "3,3,0,0,keel\n3,3.5,1.5,4,deck\n";
    for (size_t size = 0; size < sizeof text - 1; size++) {
        batten_model *model = NULL;
        batten_notes *notes = NULL;
        CHECK_OK(batten_notes_create(4, &notes));
        const batten_status status =
            read_bytes(text, size, BATTEN_FORMAT_OFFSET_TABLE, notes, &model);
        const bool quiet = status == BATTEN_OK && batten_notes_count(notes) == 0 &&
                           batten_notes_dropped(notes) == 0;
        /* A cut between two rows cannot be seen: such a table is a table. */
        const bool between = size > 0 && text[size - 1] == '\n';
        batten_model_unref(model);
        batten_notes_free(notes);
        if (status != BATTEN_OUT_OF_MEMORY)
            CHECK(!quiet || between);
    }
}
