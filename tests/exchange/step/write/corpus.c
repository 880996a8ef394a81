/* What holds of the writer over the corpora of the readers. */
#include "exchange/corpus.h"

TEST(writing_what_is_in_iges_files_says_that_memory_is_missing)
{
    static const char *const files[] = {"iges/all.igs", "iges/instances.igs",
                                        "iges/trimmed.igs"};
    const corpus c = corpus_named(BATTEN_FORMAT_IGES, files, COUNT(files));
    check_writing_without_memory(&c, BATTEN_FORMAT_STEP, 200);
}

TEST(writing_what_is_in_step_files_says_that_memory_is_missing)
{
    static const char *const files[] = {"step/assembly", "step/faces-with-parameters",
                                        "step/tessellated", "step/mapped"};
    const corpus c = corpus_named(BATTEN_FORMAT_STEP, files, COUNT(files));
    check_writing_without_memory(&c, BATTEN_FORMAT_STEP, 200);
}

TEST(writing_what_is_in_obj_files_says_that_memory_is_missing)
{
    static const char *const files[] = {"obj/mesh.obj", "obj/coloured.obj"};
    const corpus c = corpus_named(BATTEN_FORMAT_OBJ, files, COUNT(files));
    check_writing_without_memory(&c, BATTEN_FORMAT_STEP, 200);
}
