// Messages of several sizes, there and back between two processes: message 2 k goes from process 0
// to process 1, and message 2 k + 1, as long, is the answer. The content of a message is read and
// put into the next one. Sizes alternate, so that a noisy moment affects all equally.
class ChannelTimes {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr int kTurns = 25;
  static constexpr std::size_t kSizes = kMessages.size() / 2;

  // Collective; process 0 prints what it has found as a line of JSON. Returns what is wrong.
  std::string run(ChannelMode mode, int rounds) {
    const std::string wrong = channel_.open(MPI_COMM_WORLD, mode, kTimeLimit);
    if (!wrong.empty()) return wrong;
    Cores(channel_.comm()).pin();
    const double clock = clock_cost();
    std::array<std::vector<double>, kSizes> ways, sendings;
    for (int round = -1; round < rounds && status_ == kFine; ++round)  // the first one warms up
      for (std::size_t k = 0; k < kSizes; ++k) {
        const double way = time_way(static_cast<int>(2 * k));
        const double sending = time_sending(static_cast<int>(2 * k));
        if (round < 0) continue;
        ways[k].push_back(way);
        sendings[k].push_back(sending - clock);
      }
    const bool first = channel_.rank() == 0;
    channel_.close();
    if (status_ != kFine) return describe(status_).c_str();
    if (first) print(ways, sendings);
    return "";
  }

 private:
  static constexpr double kTimeLimit = 30;  // s

  // Nanoseconds from when numbers are about to be put into a message until they have been read
  // out.
  double time_way(int there) {
    const Clock::rep start = now();
    for (int turn = 0; turn < kTurns; ++turn) turn_around(there, [this](int k) { put(k); });
    return nanoseconds(now() - start) / (2 * kTurns);
  }

  // Nanoseconds until a sender can go on, a look at the clock included.
  double time_sending(int there) {
    Clock::rep sum = 0;
    for (int turn = 0; turn < kTurns; ++turn)
      turn_around(there, [this, &sum](int k) {
        const Clock::rep start = now();
        put(k);
        sum += now() - start;
      });
    return nanoseconds(sum) / kTurns;
  }

  template <class Put>
  void turn_around(int there, Put put_one) {
    if (channel_.rank() == 0) {
      put_one(there);
      take(there + 1);
    } else {
      take(there);
      put_one(there + 1);
    }
  }

  void put(int k) {
    std::copy_n(numbers_.data(), size_of(k), channel_.outgoing(k, status_));
    channel_.send(k, status_);
  }

  void take(int k) { std::copy_n(channel_.receive(k, status_), size_of(k), numbers_.data()); }

  static int size_of(int k) { return kMessages[static_cast<std::size_t>(k)].size; }
  static Clock::rep now() { return Clock::now().time_since_epoch().count(); }

  static void print(const std::array<std::vector<double>, kSizes>& ways,
                    const std::array<std::vector<double>, kSizes>& sendings) {
    std::printf("[");
    for (std::size_t k = 0; k < kSizes; ++k)
      std::printf("%s{\"numbers\": %d, \"way_ns\": %.2f, \"send_ns\": %.2f}", k == 0 ? "" : ", ",
                  kMessages[2 * k].size, statistics(ways[k]).median,
                  statistics(sendings[k]).median);
    std::printf("]\n");
  }

  Channel channel_;
  int status_ = kFine;
  std::array<Number, 4096> numbers_{};
};

// Collective: whether all processes are on one host.
inline bool share_memory() {
  MPI_Comm node;
  int size = 0;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
  MPI_Comm_size(node, &size);
  MPI_Comm_free(&node);
  return size == kProcesses;
}
