#define _XOPEN_SOURCE 700
#include "design/text/document.h"

#include "support/test.h"

#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

TEST(paths_that_leave_the_folder_are_seen)
{
    static const char *const leave[] = {"/x",  "..", "../x", "a/../../x", "a/b/../../../x",
                                        "./.."};
    static const char *const stay[] = {"x",           "a/x", "a/../x", "./x",
                                       "a/b/../../x", "..x", "a//x",   ""};
    for (int i = 0; i < COUNT(leave); i++)
        CHECK(bat_path_leaves(leave[i]));
    for (int i = 0; i < COUNT(stay); i++)
        CHECK(!bat_path_leaves(stay[i]));
}

static void touch(const char *path)
{
    FILE *file = fopen(path, "w");
    CHECK(file != NULL);
    fclose(file);
}

TEST(symlinks_that_leave_the_folder_are_refused)
{
    const char *folder = test_scratch("inside"), *design = test_scratch("inside/a.yaml");
    mkdir(folder, 0700);
    touch(test_scratch("outside.csv"));
    touch(test_scratch("inside/own.csv"));
    unlink(test_scratch("inside/link.csv"));
    CHECK(symlink("../outside.csv", test_scratch("inside/link.csv")) == 0);
    bat_document document = {.file_name = design};
    char *path = NULL;
    CHECK_OK(bat_path_beside(&document, "own.csv", &path));
    CHECK_TEXT(path, test_scratch("inside/own.csv"));
    bat_release(path);
    path = NULL;
    CHECK_STATUS(bat_path_beside(&document, "link.csv", &path), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE(
        "link.csv leads out of the folder of the design through a link; --allow-outside "
        "allows it");
    CHECK_STATUS(bat_path_beside(&document, "../outside.csv", &path), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(bat_path_beside(&document, "absent.csv", &path), BATTEN_FILE_ERROR);
    CHECK_MESSAGE("there is no such file");
    CHECK_STATUS(bat_path_beside(&document, "a\nb", &path), BATTEN_FILE_ERROR);
    CHECK_MESSAGE("a?b: there is no such file");
    CHECK(path == NULL);
    document.allow_outside = true;
    CHECK_OK(bat_path_beside(&document, "link.csv", &path));
    bat_release(path);
    CHECK_OK(bat_path_beside(&document, "/absolute", &path));
    CHECK_TEXT(path, "/absolute");
    bat_release(path);
}

TEST(outputs_do_not_leave_their_folder_through_links)
{
    char folder[300], path[400];
    snprintf(folder, sizeof folder, "%s", test_scratch("outputs"));
    bat_document document = {.file_name = "d.yaml"};
    mkdir(folder, 0777); /* there from a run before, perhaps */
    mkdir(test_scratch("elsewhere"), 0777);
    snprintf(path, sizeof path, "%s/sub", folder);
    mkdir(path, 0777);
    static const struct {
        const char *name, *target; /* a link of this name, relative; NULL: none */
        const char *output;
        batten_status status;
    } cases[] = {
        {NULL, NULL, "plain.step", BATTEN_OK},
        {NULL, NULL, "sub/plain.step", BATTEN_OK},
        {NULL, NULL, "missing/plain.step", BATTEN_OK},
        {"inner", "sub", "inner/x.step", BATTEN_OK},
        {"out", "../elsewhere", "out/x.step", BATTEN_BAD_ARGUMENT},
        {"chain", "out", "chain/x.step", BATTEN_BAD_ARGUMENT},
        {"nowhere.step", "../elsewhere/new.step", "nowhere.step", BATTEN_FILE_ERROR},
        {"up", "..", "up/elsewhere/x.step", BATTEN_BAD_ARGUMENT},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        snprintf(path, sizeof path, "%s/%s", folder, cases[i].name ? cases[i].name : "");
        if (cases[i].name) {
            unlink(path);
            CHECK_INT(symlink(cases[i].target, path), 0);
        }
        snprintf(path, sizeof path, "%s/%s", folder, cases[i].output);
        CHECK_STATUS(bat_path_check_inside(&document, folder, path), cases[i].status);
    }
    touch(test_scratch("elsewhere/there.step"));
    snprintf(path, sizeof path, "%s/there.step", folder);
    unlink(path);
    CHECK_INT(symlink("../elsewhere/there.step", path), 0);
    CHECK_STATUS(bat_path_check_inside(&document, folder, path), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("through a link; --allow-outside allows it");
    document.allow_outside = true;
    CHECK_OK(bat_path_check_inside(&document, folder, path));
}
