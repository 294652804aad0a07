/** Asks one question at a time; of those that come up meanwhile, the last. */
export class OneAtATime<Question, Answer> {
  private isBusy = false;
  private waiting: { question: Question } | undefined;
  /** Grows when all is forgotten, so that answers to what was asked before are known. */
  private turn = 0;

  constructor(
    private readonly ask: (question: Question) => Promise<Answer>,
    private readonly answered: (answer: Answer, question: Question) => void,
  ) {}

  put(question: Question): void {
    this.waiting = { question };
    if (!this.isBusy) void this.run();
  }

  forget(): void {
    ++this.turn;
    this.waiting = undefined;
  }

  private async run(): Promise<void> {
    this.isBusy = true;
    for (let next = this.take(); next !== undefined; next = this.take()) {
      const { turn } = this;
      const { question } = next;
      // A question without an answer is asked again with the next frame.
      const answer = await this.ask(question).then((value) => ({ value }), () => undefined);
      if (answer !== undefined && turn === this.turn) this.answered(answer.value, question);
    }
    this.isBusy = false;
  }

  private take(): { question: Question } | undefined {
    const next = this.waiting;
    this.waiting = undefined;
    return next;
  }
}
