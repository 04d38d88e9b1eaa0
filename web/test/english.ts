/** What is tested outside of a browser speaks English. */
import { speak } from "../src/texts";

await speak("en");
