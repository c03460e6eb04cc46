#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace groundgrid::program {

/// A thread that does one job after another. To start one for each job would cost a tenth of a
/// millisecond, with the memory that every new thread takes.
class WorkerThread {
 public:
  WorkerThread();
  /// Waits for the job; what it throws is lost.
  ~WorkerThread();
  WorkerThread(const WorkerThread&) = delete;
  WorkerThread& operator=(const WorkerThread&) = delete;
  WorkerThread(WorkerThread&&) = delete;
  WorkerThread& operator=(WorkerThread&&) = delete;

  /// Not before the job given last was waited for.
  void start(std::function<void()> job);

  /// Returns when the job is done, at once where there is none. Throws what the job threw.
  void wait();

 private:
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> job_;  // empty once it is done
  std::exception_ptr problem_;
  bool ends_ = false;
  std::thread thread_;  // the last one: it uses all others
};

}  // namespace groundgrid::program
