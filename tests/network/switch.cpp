// A network of hosts in one process: each host is a TUN device, packets go from one to another
// after a delay, or are lost.
//
// switch HOSTS: makes devices host1 ... hostN in the network namespace that it runs in (they can be
// moved to others) and says "ready". A packet to an address that ends in K goes to hostK. Then
// it takes commands, a line each, and answers each by "done":
//   delay US   from now on packets are under way for so many microseconds
//   loss SHARE from now on that share of packets is lost (0 to 1), the same ones in every run
//   cut K      nothing goes to hostK or comes from it any more;  mend K: it does again
#include <fcntl.h>
#include <linux/if.h>
#include <linux/if_tun.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <random>
#include <string>
#include <vector>

using Clock = std::chrono::steady_clock;

struct Packet {
  Clock::time_point due;
  std::size_t to;
  std::vector<char> bytes;
};

class Switch {
 public:
  explicit Switch(std::size_t hosts) : cut_(hosts) {
    for (unsigned k = 1; k <= hosts; ++k) devices_.push_back(make_device(k));
  }

  int run() {
    std::vector<pollfd> watched{{STDIN_FILENO, POLLIN, 0}};
    for (const int device : devices_) watched.push_back({device, POLLIN, 0});
    for (;;) {
      // Looks again and again while packets are under way: a sleep may last longer than they are.
      if (poll(watched.data(), watched.size(), under_way_.empty() ? -1 : 0) < 0) return 1;
      if ((watched[0].revents & (POLLIN | POLLHUP)) != 0 && !obey()) return 0;
      for (std::size_t k = 0; k < devices_.size(); ++k)
        if ((watched[k + 1].revents & POLLIN) != 0) take_from(k);
      deliver();
    }
  }

 private:
  static int make_device(unsigned k) {
    const int device = open("/dev/net/tun", O_RDWR | O_NONBLOCK);
    ifreq asked{};
    asked.ifr_flags = IFF_TUN | IFF_NO_PI;
    std::snprintf(asked.ifr_name, sizeof asked.ifr_name, "host%u", k);
    if (device < 0 || ioctl(device, TUNSETIFF, &asked) < 0) {
      std::perror("error: cannot make a TUN device");
      std::exit(3);
    }
    return device;
  }

  bool obey() {
    char line[100];
    if (std::fgets(line, sizeof line, stdin) == nullptr) return false;
    char what[20] = "";
    double value = 0;
    std::sscanf(line, "%19s %lf", what, &value);
    const std::string word = what;
    if (word == "delay") delay_ = std::chrono::nanoseconds(static_cast<long>(1e3 * value));
    if (word == "loss") loss_ = std::bernoulli_distribution(value);
    if (word == "cut" || word == "mend")
      cut_.at(static_cast<std::size_t>(value) - 1) = word == "cut";
    std::puts("done");
    std::fflush(stdout);
    return true;
  }

  void take_from(std::size_t k) {
    char bytes[65536];
    constexpr int kBurst = 64;  // others have their turn, too
    for (int n = 0; n < kBurst; ++n) {
      const ssize_t size = read(devices_[k], bytes, sizeof bytes);
      if (size < 20) return;
      const std::size_t to = static_cast<unsigned char>(bytes[19]) - std::size_t{1};
      const bool ipv4 = (bytes[0] & 0xf0) == 0x40;
      if (!ipv4 || to >= devices_.size() || cut_[k] || loss_(random_)) continue;
      under_way_.push_back({Clock::now() + delay_, to, {bytes, bytes + size}});
    }
  }

  void deliver() {
    while (!under_way_.empty() && under_way_.front().due <= Clock::now()) {
      const Packet& packet = under_way_.front();
      if (!cut_[packet.to])  // a device that takes none loses it, as hardware does
          [[maybe_unused]]
        const auto written = write(devices_[packet.to], packet.bytes.data(), packet.bytes.size());
      under_way_.pop_front();
    }
  }

  std::vector<int> devices_;
  std::vector<bool> cut_;
  std::deque<Packet> under_way_;
  Clock::duration delay_{};
  std::bernoulli_distribution loss_{0.0};
  std::mt19937 random_{1};
};

int main(int count, char** words) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setpriority(PRIO_PROCESS, 0, -20);  // no cable waits until a process that computes rests
  Switch made(count == 2 ? static_cast<std::size_t>(std::atoi(words[1])) : 0);
  std::puts("ready");
  std::fflush(stdout);
  return made.run();
}
