// SPDX-License-Identifier: Apache-2.0
// Runs the light controller's firmware, the very .hex, in simavr, with its serial line on a pseudo-terminal.
// For tests only: simavr is under the GPL, so no library links this file and nothing installs it.
//
//   simulated-controller FIRMWARE.hex [--pull down|up] [--boot-ms N] [--speed X]
//
// --pull     where the external resistors hold a pin that floats; up is the document's inverted circuit, in
//            which a low pin lights its light (default down)
// --boot-ms  how long a boot loader keeps the line after a reset before the firmware starts (default 0)
// --speed    simulated seconds for one of the wall's (default 1)
//
// Standard output, a line each, times in simulated seconds:
//   port /dev/pts/N
//   T reset WHY            power, open (somebody opened the port: DTR), command, or watchdog
//   T pins D2...D10 MASK   one letter a pin: 0 1 driven low, high; l h floating, held low, high by the
//   resistor;
//                          and what is lit, in hex, bit n for channel n
//   T time                 in answer to the command `time`
// Standard input, a line each: reset | brownout | hang | mute | unmute | noise | time | quit.
#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>

#include <fcntl.h>
#include <poll.h>
#include <simavr/avr_extint.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_hex.h>
#include <termios.h>
#include <unistd.h>

namespace {

constexpr double kFrequency = 16e6;
constexpr avr_cycle_count_t kChunk = 8000;       // half a millisecond
constexpr avr_cycle_count_t kByteCycles = 1360;  // 10 bits at 117647 baud
// Where the ATmega328P keeps them in its data memory.
constexpr int kPinB = 0x23, kPinD = 0x29;

// A port's registers as the firmware wrote them last.
struct Port {
  char letter;
  std::uint32_t level = 0, driven = 0;
  avr_irq_t* level_irq = nullptr;
  avr_irq_t* driven_irq = nullptr;
};

struct Machine {
  avr_t* avr = nullptr;
  int master = -1;
  bool pull_up = false;
  double boot_ms = 0.0;
  bool muted = false, noise = false;
  bool xoff = false;
  bool restored = true;
  std::string flash;  // as it was loaded
  const char* reset_why = "power";
  avr_cycle_count_t deaf_until = 0;
  Port b{'B'}, d{'D'};
  std::string shown;
  void (*core_reset)(avr_t*) = nullptr;
};
Machine machine;  // simavr's callbacks of a core carry no pointer of ours

double Seconds() { return static_cast<double>(machine.avr->cycle) / kFrequency; }

void Say(const std::string& text) {
  std::printf("%.6f %s\n", Seconds(), text.c_str());
  std::fflush(stdout);
}

[[noreturn]] void Die(const std::string& why) {
  std::fprintf(stderr, "simulated-controller: %s\n", why.c_str());
  std::exit(1);
}

// What stands on the light pins, D2 to D10, and which lights that lights.
std::string Pins() {
  const std::uint32_t level = (machine.d.level >> 2 & 0x3F) | (machine.b.level & 7) << 6;
  const std::uint32_t driven = (machine.d.driven >> 2 & 0x3F) | (machine.b.driven & 7) << 6;
  std::string text = "pins ";
  int lit = 0;
  for (int i = 0; i < 9; ++i) {
    const bool high = (driven >> i & 1) != 0 ? (level >> i & 1) != 0 : machine.pull_up;
    if ((driven >> i & 1) != 0) {
      text += high ? '1' : '0';
    } else {
      text += high ? 'h' : 'l';
    }
    if (high != machine.pull_up) lit |= 1 << i;
  }
  char mask[16];
  std::snprintf(mask, sizeof mask, " %03X", lit);
  return text + mask;
}

void ShowPins() {
  std::string now = Pins();
  if (now == machine.shown) return;
  machine.shown = std::move(now);
  Say(machine.shown);
}

void OnLevel(avr_irq_t*, std::uint32_t value, void* port) {
  static_cast<Port*>(port)->level = value;
  ShowPins();
}
void OnDirection(avr_irq_t*, std::uint32_t value, void* port) {
  static_cast<Port*>(port)->driven = value;
  ShowPins();
}

// The resistors' levels, where the firmware reads them while the pins are inputs.
void HoldPins() {
  machine.avr->data[kPinD] = machine.pull_up ? 0xFF : 0x00;
  machine.avr->data[kPinB] = machine.pull_up ? 0xFF : 0x00;
  for (const char port : {'B', 'D'}) {
    avr_ioport_external_t external = {};
    external.name = static_cast<unsigned char>(port) & 0x7FU;
    external.mask = 0xFF;
    external.value = machine.pull_up ? 0xFF : 0x00;
    avr_ioctl(machine.avr, static_cast<std::uint32_t>(AVR_IOCTL_IOPORT_SET_EXTERNAL(port)), &external);
  }
}

void OnReset(avr_t* avr) {
  if (machine.core_reset != nullptr) machine.core_reset(avr);
  if (!machine.restored) {
    std::memcpy(avr->flash, machine.flash.data(), machine.flash.size());
    machine.restored = true;
  }
  for (Port* port : {&machine.b, &machine.d}) {
    port->level = port->driven = 0;
    port->level_irq->value = port->driven_irq->value = 0;  // or simavr keeps back the first write of the same
  }
  HoldPins();
  Say(std::string("reset ") + machine.reset_why);
  machine.reset_why = "watchdog";  // whatever nobody below has announced
  ShowPins();
}

void Reset(const char* why, const avr_regbit_t& flag) {
  machine.reset_why = why;
  avr_reset(machine.avr);
  avr_regbit_set(machine.avr, flag);
  HoldPins();
  machine.deaf_until =
      machine.avr->cycle + static_cast<avr_cycle_count_t>(machine.boot_ms * 1e-3 * kFrequency);
}

void OnOutput(avr_irq_t*, std::uint32_t value, void*) {
  if (machine.muted) return;
  const char byte = static_cast<char>(value);
  if (write(machine.master, &byte, 1) != 1) return;  // nobody reads: lost, as on a wire
}
void OnXoff(avr_irq_t*, std::uint32_t, void*) { machine.xoff = true; }
void OnXon(avr_irq_t*, std::uint32_t, void*) { machine.xoff = false; }
void NoSleep(avr_t*, avr_cycle_count_t) {}
void Log(avr_t*, const int level, const char* format, va_list arguments) {
  if (level <= LOG_ERROR) std::vfprintf(stderr, format, arguments);
}

void OpenTerminal() {
  machine.master = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
  if (machine.master < 0 || grantpt(machine.master) != 0 || unlockpt(machine.master) != 0)
    Die("cannot open a pseudo-terminal");
  const char* name = ptsname(machine.master);
  // Raw from the start, and opened once, so that the master sees a hang-up until somebody opens it.
  const int slave = open(name, O_RDWR | O_NOCTTY);
  termios raw = {};
  if (slave < 0 || tcgetattr(slave, &raw) != 0) Die("cannot set up the pseudo-terminal");
  cfmakeraw(&raw);
  tcsetattr(slave, TCSANOW, &raw);
  close(slave);
  std::printf("port %s\n", name);
  std::fflush(stdout);
}

// True while somebody has the port open.
bool PortIsOpen() {
  pollfd poll_master = {machine.master, POLLIN, 0};
  return poll(&poll_master, 1, 0) >= 0 && (poll_master.revents & POLLHUP) == 0;
}

void Obey(const std::string& command) {
  avr_t* avr = machine.avr;
  if (command == "reset") {
    Reset("command", avr->reset_flags.extrf);
  } else if (command == "brownout") {
    Reset("command", avr->reset_flags.borf);
  } else if (command == "hang") {  // every word of the flash jumps to itself, interrupts included
    for (std::size_t i = 0; i + 1 < machine.flash.size(); i += 2) {
      avr->flash[i] = 0xFF;
      avr->flash[i + 1] = 0xCF;
    }
    machine.restored = false;
  } else if (command == "mute") {
    machine.muted = true;
  } else if (command == "unmute") {
    machine.muted = false;
  } else if (command == "noise") {  // the next byte in comes with a framing error
    machine.noise = true;
  } else if (command == "time") {
    Say("time");
  } else if (command == "quit") {
    std::exit(0);
  }
}

// Commands that have come in; false at the end of the input: whoever started this is gone.
bool ReadCommands() {
  static std::string pending;
  pollfd poll_in = {STDIN_FILENO, POLLIN, 0};
  while (poll(&poll_in, 1, 0) > 0) {
    char bytes[256];
    const ssize_t count = read(STDIN_FILENO, bytes, sizeof bytes);
    if (count <= 0) return false;
    pending.append(bytes, static_cast<std::size_t>(count));
    for (std::size_t end = 0; (end = pending.find('\n')) != std::string::npos; pending.erase(0, end + 1)) {
      Obey(pending.substr(0, end));
    }
  }
  return true;
}

void LoadFirmware(const char* path) {
  std::uint32_t size = 0, start = 0;
  std::uint8_t* code = read_ihex_file(path, &size, &start);
  if (code == nullptr || start != 0 || size > machine.avr->flashend)
    Die(std::string("no firmware in ") + path);
  avr_loadcode(machine.avr, code, size, 0);
  machine.flash.assign(reinterpret_cast<const char*>(code), size);
  std::free(code);
}

void FeedBytes(avr_irq_t* input, avr_cycle_count_t& next_byte) {
  avr_t* avr = machine.avr;
  if (avr->cycle < next_byte || machine.xoff) return;
  char byte = 0;
  if (read(machine.master, &byte, 1) != 1) {
    next_byte = avr->cycle + kByteCycles;
    return;
  }
  next_byte = avr->cycle + kByteCycles;
  if (avr->cycle < machine.deaf_until) return;  // the boot loader has it
  const std::uint32_t error = machine.noise ? static_cast<std::uint32_t>(UART_INPUT_FE) : 0U;
  machine.noise = false;
  avr_raise_irq(input, static_cast<std::uint8_t>(byte) | error);
}

double Wall() {
  timespec now = {};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void Run(double speed) {
  avr_t* avr = machine.avr;
  avr_irq_t* input =
      avr_io_getirq(avr, static_cast<std::uint32_t>(AVR_IOCTL_UART_GETIRQ('0')), UART_IRQ_INPUT);
  avr_cycle_count_t next_byte = 0;
  bool was_open = false;
  double origin = Wall() - Seconds() / speed;
  while (ReadCommands()) {
    const bool is_open = PortIsOpen();
    if (is_open && !was_open) Reset("open", avr->reset_flags.extrf);
    was_open = is_open;
    // Or simavr polls INT0 and INT1, which nobody uses, in every cycle while their pins are low.
    for (const std::uint8_t number : {0, 1}) avr_extint_set_strict_lvl_trig(avr, number, 0);
    const avr_cycle_count_t end = avr->cycle + kChunk;
    while (avr->cycle < end) {
      if (avr->cycle < machine.deaf_until) {
        avr->cycle += kByteCycles;
      } else {
        const int state = avr_run(avr);
        if (state == cpu_Done || state == cpu_Crashed) Die("the firmware has crashed");
      }
      if (is_open) FeedBytes(input, next_byte);
    }
    const double ahead = origin + Seconds() / speed - Wall();
    if (ahead > 0.0) usleep(static_cast<useconds_t>(ahead * 1e6));
    // A pause of the whole machine must not be made up for: time would pass too fast for the host.
    if (ahead < -0.02) origin -= ahead + 0.02;
  }
}

}  // namespace

int main(int argc, char** argv) {
  double speed = 1.0;
  for (int i = 2; i + 1 < argc; i += 2) {
    if (std::strcmp(argv[i], "--pull") == 0) machine.pull_up = std::strcmp(argv[i + 1], "up") == 0;
    if (std::strcmp(argv[i], "--boot-ms") == 0) machine.boot_ms = std::atof(argv[i + 1]);
    if (std::strcmp(argv[i], "--speed") == 0) speed = std::fmax(0.01, std::atof(argv[i + 1]));
  }
  if (argc < 2 || argc % 2 != 0) Die("usage: simulated-controller FIRMWARE.hex [--pull down|up] ...");
  avr_global_logger_set(Log);
  machine.avr = avr_make_mcu_by_name("atmega328p");
  if (machine.avr == nullptr) Die("simavr does not know the ATmega328P");
  avr_t* avr = machine.avr;
  avr_init(avr);
  avr->frequency = static_cast<std::uint32_t>(kFrequency);
  avr->sleep = NoSleep;
  avr->run_cycle_limit = kByteCycles / 4;
  LoadFirmware(argv[1]);
  OpenTerminal();
  machine.core_reset = avr->reset;
  avr->reset = OnReset;
  std::uint32_t flags = 0;
  avr_ioctl(avr, static_cast<std::uint32_t>(AVR_IOCTL_UART_GET_FLAGS('0')), &flags);
  flags &= ~static_cast<std::uint32_t>(AVR_UART_FLAG_STDIO | AVR_UART_FLAG_POLL_SLEEP);
  avr_ioctl(avr, static_cast<std::uint32_t>(AVR_IOCTL_UART_SET_FLAGS('0')), &flags);
  const auto uart = [avr](int irq) {
    return avr_io_getirq(avr, static_cast<std::uint32_t>(AVR_IOCTL_UART_GETIRQ('0')), irq);
  };
  avr_irq_register_notify(uart(UART_IRQ_OUTPUT), OnOutput, nullptr);
  avr_irq_register_notify(uart(UART_IRQ_OUT_XON), OnXon, nullptr);
  avr_irq_register_notify(uart(UART_IRQ_OUT_XOFF), OnXoff, nullptr);
  for (Port* port : {&machine.b, &machine.d}) {
    const auto ctl = static_cast<std::uint32_t>(AVR_IOCTL_IOPORT_GETIRQ(port->letter));
    port->level_irq = avr_io_getirq(avr, ctl, IOPORT_IRQ_REG_PORT);
    port->driven_irq = avr_io_getirq(avr, ctl, IOPORT_IRQ_DIRECTION_ALL);
    avr_irq_register_notify(port->level_irq, OnLevel, port);
    avr_irq_register_notify(port->driven_irq, OnDirection, port);
  }
  Reset("power", avr->reset_flags.porf);
  Run(speed);
  return 0;
}
