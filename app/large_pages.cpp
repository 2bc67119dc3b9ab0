// The program's memory by jemalloc, which reads this text when it starts: in pages of 2 MiB where the system has them
// (transparent huge pages), and what was freed is kept for the next field. Fields of fine grids are gone through from
// end to end many times; with pages of 4 KiB a third to a half of a large contact's time went into finding them, on a
// virtual machine. One arena is enough, since what is solved many times takes no memory.

namespace microslip::app {
extern "C" {

extern const char* malloc_conf; // as jemalloc.h has it
const char* malloc_conf = "thp:always,dirty_decay_ms:-1,oversize_threshold:0,narenas:1";
}
} // namespace microslip::app
