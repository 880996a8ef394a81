/* What a file must not do when memory fails, or a limit is reached, while it is read. */
#ifndef FUZZ_FAULTS_H
#define FUZZ_FAULTS_H
#include <batten/exchange.h>
#include <stddef.h>
#include <stdint.h>

/* Count allocations from now on; call it before the library allocates. */
void fuzz_faults_begin(void);

/* Read the bytes as a format, with one allocation failing, then with all from it on; again for
 * `most` of its allocations, evenly over the whole reading. A model comes with success alone,
 * and no memory is kept. False, with a line on stderr, when it was not so. */
bool fuzz_faults(const char *name, const uint8_t *data, size_t size, batten_format format,
                 long most);
/* The same with each limit, and the budget of work, very low in turn. */
bool fuzz_limits(const char *name, const uint8_t *data, size_t size, batten_format format);

#endif
