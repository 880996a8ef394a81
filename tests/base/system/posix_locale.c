/* Numbers are the same in any locale. */
#define _XOPEN_SOURCE 700
#include "base/base.h"
#include "base/numbers.h"
#include "base/system.h"

#include <batten/text.h>

#include <locale.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <wchar.h>

static void check_locale(const char *name)
{
    if (!setlocale(LC_ALL, name))
        SKIP("the locale %s is not installed", name);
    char text[BATTEN_NUMBER_SIZE];
    batten_number_write(1234567.25, text);
    const double value = read_all("1.5");
    setlocale(LC_ALL, "C");
    CHECK_TEXT(text, "1234567.25");
    CHECK_BITS(value, 1.5);
}

TEST(F5_numbers_are_the_same_in_german)
{
    check_locale("de_DE.UTF-8");
}

TEST(F5_numbers_are_the_same_in_turkish)
{
    check_locale("tr_TR.UTF-8");
}

/* A letter beyond ASCII tells: UTF-8 writes it, the C locale refuses it. */
TEST(F5_text_is_formatted_in_the_c_locale_and_that_of_the_thread_stays)
{
    /* Not newlocale, which loses memory in glibc where LOCPATH is set. */
    if (!setlocale(LC_ALL, "C.UTF-8"))
        SKIP("the locale C.UTF-8 is not installed");
    const locale_t own = duplocale(LC_GLOBAL_LOCALE);
    setlocale(LC_ALL, "C");
    CHECK(own != (locale_t)0);
    char text[8], letter[8];
    uselocale(own);
    const int length = batten_text_print(text, sizeof text, "%g", 0.5);
    const int refused = batten_text_print(letter, sizeof letter, "%lc", (wint_t)0xe4);
    const bool kept = uselocale((locale_t)0) == own;
    const int written = snprintf(letter, sizeof letter, "%lc", (wint_t)0xe4);
    uselocale(LC_GLOBAL_LOCALE);
    freelocale(own);
    CHECK(kept);
    CHECK_INT(length, 3);
    CHECK_TEXT(text, "0.5");
    CHECK_INT(refused, -1);
    CHECK_INT(written, 2);
}

static atomic_bool stop_switching;

static void *switch_locale(void *user)
{
    (void)user;
    while (!atomic_load(&stop_switching)) {
        setlocale(LC_ALL, "de_DE.UTF-8");
        setlocale(LC_ALL, "C");
    }
    return NULL;
}

TEST(F5_numbers_are_the_same_while_another_thread_switches_the_locale)
{
    if (!setlocale(LC_ALL, "de_DE.UTF-8"))
        SKIP("the locale de_DE.UTF-8 is not installed");
    pthread_t thread;
    atomic_store(&stop_switching, false);
    CHECK(pthread_create(&thread, NULL, switch_locale, NULL) == 0);
    bool same = true;
    for (int i = 0; i < test_cases(2000) && same; i++) {
        char text[BATTEN_NUMBER_SIZE];
        double value = 0;
        batten_number_write(i + 0.5, text);
        same = strchr(text, '.') &&
               batten_number_read(text, strlen(text), &value, NULL) == BATTEN_OK &&
               value == i + 0.5;
    }
    atomic_store(&stop_switching, true);
    pthread_join(thread, NULL);
    setlocale(LC_ALL, "C");
    CHECK(same);
}
