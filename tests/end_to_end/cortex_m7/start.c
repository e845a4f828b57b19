/* Start of a program on a Cortex-M7 without operating system (the board mps2-an500 of QEMU): vectors,
   floating-point unit on, then newlib's start, whose files and output are those of the host. */
extern void _start(void);
extern char stack_top[];

static void reset(void) {
  *(volatile unsigned*)0xE000ED88u |= 0xFu << 20; /* CPACR: access to the floating-point unit */
  __asm volatile("dsb\n\tisb");
  _start();
}

static void fault(void) { __asm volatile("bkpt 0"); }

__attribute__((section(".vectors"), used)) static const void* const vectors[7] = {
    stack_top, (void*)reset, (void*)fault, (void*)fault, (void*)fault, (void*)fault, (void*)fault};
