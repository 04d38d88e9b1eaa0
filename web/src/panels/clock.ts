/** The time of the motion that is shown: one clock for the turning body and the flashing crossings. */
export class Clock {
  time = 0;
  playing = false;
  /** Units of time a second. */
  speed = 1;
  /** The last moment of the motion. */
  end = 0;
  /** How long a crossing glows, in units of time. */
  get glow(): number {
    return 1.2 * this.speed;
  }
  private readonly listeners: (() => void)[] = [];
  private before = 0;

  on(listener: () => void): void {
    this.listeners.push(listener);
  }

  play(): void {
    if (this.playing) return;
    this.playing = true;
    this.before = performance.now();
    requestAnimationFrame(this.tick);
    this.tell();
  }

  pause(): void {
    this.playing = false;
    this.tell();
  }

  to(time: number): void {
    this.time = Math.min(this.end, Math.max(0, time));
    this.tell();
  }

  private readonly tick = (now: number): void => {
    if (!this.playing) return;
    this.time += (Math.min(100, Math.max(0, now - this.before)) / 1000) * this.speed;
    this.before = now;
    if (this.time > this.end) this.time = 0;
    this.tell();
    requestAnimationFrame(this.tick);
  };

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}
