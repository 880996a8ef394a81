#include "design/text/document.h"

#include "support/test.h"

#include <string.h>

/* A document of features alone, named as the test wants. */
static batten_status sort_document(int count, char names[][12], bat_entry *entries,
                                   bat_document *out)
{
    for (int i = 0; i < count; i++)
        entries[i] = (bat_entry){.name = names[i]};
    *out = (bat_document){.feature_count = count, .features = entries};
    return bat_names_sort(out);
}

TEST(every_name_is_found_at_its_feature_and_no_other)
{
    enum { COUNT = 97 };
    static char names[COUNT][12];
    static bat_entry entries[COUNT];
    for (int count = 0; count <= COUNT; count += count < 5 ? 1 : 23) {
        bat_document document;
        for (int i = 0; i < count; i++)
            snprintf(names[i], sizeof names[i], "f%d", 2 * ((i * 37) % 97)); /* all distinct */
        const batten_status status = sort_document(count, names, entries, &document);
        if (status == BATTEN_OK) {
            for (int i = 0; i < count; i++)
                CHECK_INT(bat_document_feature(&document, names[i]), i);
            CHECK_INT(bat_document_feature(&document, "f1"), -1);
            CHECK_INT(bat_document_feature(&document, ""), -1);
            CHECK_INT(bat_document_feature(&document, "z"), -1);
        } else {
            CHECK(test_memory_failed(status, BATTEN_OK));
        }
        bat_arena_free(&document.arena);
    }
}
