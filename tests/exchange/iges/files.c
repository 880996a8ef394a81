/* Whole files of all kinds of entities, cut, bent and made large. */
#include "exchange/iges/text.h"

static const char *const seeds[] = {"arcs",          "composite", "conics",  "copious",
                                    "splines",       "ruled",     "turned",  "offsets",
                                    "groups",        "instances", "trimmed", "trimmed_plane",
                                    "bounded_plane", "bounded",   "solid",   "closed"};

static char *load_seed(int i, size_t *size)
{
    char path[300];
    snprintf(path, sizeof path, "%sfuzz/corpus/iges/%s.igs", test_source(""), seeds[i]);
    return load_bytes(path, size);
}

TEST(F2_files_of_all_kinds_cut_anywhere_are_never_a_quiet_whole)
{
    if (test_cases(1000) < 1000)
        SKIP("long; its allocations are those of other tests");
    for (int i = 0; i < COUNT(seeds); i++) {
        size_t size = 0;
        const char *data = load_seed(i, &size);
        /* After the letter T in column 73 of the last record nothing is missing but blanks. */
        for (size_t cut = 0; cut <= size - 81 + 72; cut += cut + 400 < size ? 13 : 1) {
            batten_model *model = NULL;
            CHECK(read_bytes(data, cut, BATTEN_FORMAT_IGES, NULL, &model) != BATTEN_OK);
            batten_model_unref(model);
        }
    }
}

TEST(Q4_files_of_all_kinds_with_numbers_changed_are_read_or_refused)
{
    test_random random = test_random_begin(__func__);
    if (test_cases(1000) < 1000)
        SKIP("long; its allocations are those of other tests");
    for (int i = 0; i < COUNT(seeds); i++) {
        size_t size = 0;
        const char *data = load_seed(i, &size);
        char *bent = test_array(size + 1, 1);
        for (int n = 0; n < test_cases(200); n++) {
            memcpy(bent, data, size);
            for (int k = test_random_int(&random, 1, 3); k > 0; k--) {
                size_t at = (size_t)test_random_int(&random, 0, (int)size - 1);
                while (at < size && !(bent[at] >= '0' && bent[at] <= '9'))
                    at++;
                if (at < size)
                    bent[at] = (char)('0' + test_random_int(&random, 0, 9));
            }
            batten_model *model = NULL;
            const batten_status status =
                read_bytes(bent, size, BATTEN_FORMAT_IGES, NULL, &model);
            CHECK((status == BATTEN_OK || status == BATTEN_PARTLY_READ) == (model != NULL));
            batten_model_unref(model);
        }
    }
}

/* Each 102 twice the next: 2^n members, which the shared parameters must not become. */
TEST(S4_composites_that_double_are_refused_before_they_fill_the_memory)
{
    enum { DEEP = 40 };
    if (test_cases(1000) < 1000)
        SKIP("long; its allocations are those of other tests");
    iges_text file = iges_begin();
    batten_model *model = NULL;
    char text[40];
    for (int i = 0; i < DEEP; i++) {
        snprintf(text, sizeof text, "102,2,%d,%d;", 2 * i + 3, 2 * i + 3);
        iges_add(&file, 102, 0, 0, 0, "00000000", text);
    }
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    CHECK_STATUS(read_text(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, NULL, &model),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("share their parameters");
}

/* Instances that double keep one definition for each level. */
TEST(S4_instances_that_double_share_their_definitions)
{
    enum { DEEP = 24 };
    iges_text file = iges_begin();
    batten_model *model = NULL;
    char text[40];
    for (int i = 0; i < DEEP; i++) {
        const int first = 6 * i + 1;
        snprintf(text, sizeof text, "308,0,1Ha,2,%d,%d;", first + 2, first + 4);
        iges_add(&file, 308, 0, 0, 0, "00000200", text);
        snprintf(text, sizeof text, "408,%d,1.,0.,0.,1.;", first + 6);
        iges_add(&file, 408, 0, 0, 0, "00010000", text);
        iges_add(&file, 408, 0, 0, 0, "00010000", text);
    }
    iges_add(&file, 308, 0, 0, 0, "00000200", "308,0,1Ha,1,147;");
    iges_add(&file, 116, 0, 0, 0, "00010000", "116,1.,2.,3.;");
    iges_add(&file, 408, 0, 0, 0, "00000000", "408,1,0.,0.,0.,1.;");
    CHECK_OK(read_text(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, NULL, &model));
    CHECK_INT(batten_model_count(model), 1);
    CHECK_INT(batten_model_depth(model), DEEP + 1);
    batten_model_unref(model);
}
