#ifndef BATTEN_FILE_H
#define BATTEN_FILE_H
/**
 * @file
 * Whole files in memory, and bytes into files safely.
 */
#include <batten/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * A whole file in memory, with a zero byte after its end. Release with batten_release.
 *
 * @param path   a file, a device, or a pipe that somebody writes into: nobody is waited for
 * @param limit  bytes allowed
 * @return BATTEN_FILE_ERROR with the system's reason, or BATTEN_TOO_LARGE
 */
BATTEN_API batten_status batten_load_file(const char *path, size_t limit, char **data,
                                          size_t *size);

/**
 * Put bytes into a file so that, whatever happens, either the old file or the new one is there,
 * whole: written beside it, synchronised, renamed. A symlink's target is replaced, the mode is
 * kept, a read-only file is refused. A pipe or device is written straight. What savings of the
 * same file left beside it when their process was killed is removed.
 *
 * SIGINT, SIGTERM and SIGHUP wait in the calling thread while the file beside exists. One that
 * arrives before the renaming ends the call with BATTEN_CANCELLED, the old file untouched; then
 * the signal takes its course. So a programme need not clean up after its own end.
 *
 * @return BATTEN_FILE_ERROR naming the path and the system's reason; then no stray file
 * remains. When only the directory could not be synchronised, the message says that the file
 * was saved but may not survive a power loss. BATTEN_CANCELLED, as above.
 */
BATTEN_API batten_status batten_save_file(const char *path, const char *data, size_t size);

#ifdef __cplusplus
}
#endif
#endif
