#include "program/worker_thread.hpp"

#include <utility>

namespace groundgrid::program {

WorkerThread::WorkerThread() : thread_([this] { work(); }) {}

WorkerThread::~WorkerThread() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void WorkerThread::start(std::function<void()> job) {
  {
    const std::lock_guard lock(mutex_);
    job_ = std::move(job);
  }
  changed_.notify_all();
}

void WorkerThread::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !job_; });
  if (problem_) std::rethrow_exception(std::exchange(problem_, nullptr));
}

void WorkerThread::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return job_ || ends_; });
    if (!job_) return;
    lock.unlock();
    std::exception_ptr problem;
    try {
      job_();
    } catch (...) {
      problem = std::current_exception();
    }
    lock.lock();
    problem_ = std::move(problem);
    job_ = nullptr;
    changed_.notify_all();
  }
}

}  // namespace groundgrid::program
